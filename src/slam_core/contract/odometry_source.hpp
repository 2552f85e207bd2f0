// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "slam_core/contract/component.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam {

/// The role of an idiothetic source: raw data in, motion increments with complete covariance out
/// (thesis 3.4.1), at the output `motion`. describe() declares its inputs.
class OdometrySource : public Component {
 public:
  static constexpr const char* kRole = "odometry source";

  /// Sets the seed of all random streams. Called after configure(), before the first input (a
  /// Backend is seeded before it is configured).
  virtual void seed(std::uint64_t /*seed*/) {}
  /// The name of a source that has an odometry frame of its own, such as "visual"; its odometry is
  /// published on the topic `NAME_odometry/odom`. If it is empty, the odometry is not published,
  /// and a source that takes in the wheel driver's odometry uses that driver's frame. So the name
  /// also determines who publishes odom -> base_link, see ownsOdometryEdge().
  virtual std::string name() const { return ""; }
  /// To be called after restoreState() if the robot may have moved while this process did not run.
  /// A source that measures motion by what it saw before starts afresh, since it may see another
  /// place now. Wheel encoders have gone on counting.
  virtual void goOnLive() {}
  /// The output of the last execute(); nothing after the first input or a bad one.
  virtual const std::optional<Motion>& motion() const = 0;
};

/// Whether the source has to publish the transform odom -> base_link (REP-105: an edge has one
/// publisher). It has if it has an odometry frame of its own: its name() is not empty, or it does
/// not take in the wheel driver's odometry. Otherwise it uses the driver's frame, and the driver
/// publishes the edge.
inline bool ownsOdometryEdge(OdometrySource& source) {
  const auto ports = portsOf(source);
  const auto& inputs = ports.inputs();
  const auto is_of_driver = [](const InputPort& input) {
    return input.kind == kindOf<OdometrySample>();
  };
  return !source.name().empty() || std::none_of(inputs.begin(), inputs.end(), is_of_driver);
}

}  // namespace slam
