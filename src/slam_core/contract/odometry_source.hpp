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
/// (thesis 3.4.1), at the output `motion`. What it takes in is its own affair: describe() says so.
class OdometrySource : public Component {
 public:
  static constexpr const char* kRole = "odometry source";

  /// Sets the seed of all random streams. Called after configure(), before the first input (a
  /// Backend is seeded before it is configured).
  virtual void seed(std::uint64_t /*seed*/) {}
  /// Of a source that has an odometry frame of its own, such as "visual": it is shown on the topic
  /// `NAME_odometry/odom`. Empty: it is not shown; where it takes in the wheel driver's odometry it
  /// moves along that driver's frame. So the name also says who publishes odom -> base_link, see
  /// ownsOdometryEdge().
  virtual std::string name() const { return ""; }
  /// To be called after restoreState() where the robot has gone on without this process. A source
  /// that measures motion by what it saw itself starts afresh, since what it sees now is of another
  /// place. Wheels have counted on.
  virtual void goOnLive() {}
  /// What the last execute() made: nothing after the first input or a bad one.
  virtual const std::optional<Motion>& motion() const = 0;
};

/// Whether the transform odom -> base_link is the source's to publish (REP-105: an edge has one
/// publisher). A source has a name() where it has an odometry frame of its own. One that has none
/// and takes in the wheel driver's odometry moves along that driver's frame, and the driver
/// publishes the edge. A source that takes in none of the driver's odometry has a frame of its own
/// as well.
inline bool ownsOdometryEdge(OdometrySource& source) {
  const auto ports = portsOf(source);
  const auto& inputs = ports.inputs();
  const auto is_of_driver = [](const InputPort& input) {
    return input.kind == kindOf<OdometrySample>();
  };
  return !source.name().empty() || std::none_of(inputs.begin(), inputs.end(), is_of_driver);
}

}  // namespace slam
