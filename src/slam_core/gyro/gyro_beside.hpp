// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/settings.hpp"
#include "slam_core/gyro/calibrated_gyro.hpp"
#include "slam_core/models/turn.hpp"

namespace slam::gyro {

/// A gyro beside an odometry source whose own sensor measures turns precisely, as a laser or a
/// camera, unless it sees too little. The gyro says in advance how far the robot turned, so that
/// the source knows where to look, and how it turned where the source sees nothing. Before turns
/// have confirmed the gyro, it says nothing.
///
/// Counted: as CalibratedGyro.
class GyroBeside {
 public:
  /// @param sensor the source's, as "the laser" @throw ConfigError
  void configure(Settings& settings, const std::string& sensor);
  void reset() { gyro_.reset(); }

  void add(const ImuSample& sample) { gyro_.add(sample); }
  /// The stamp of the newest sample.
  std::optional<Stamp> end() const { return gyro_.track().end(); }
  /// The turn between two stamps; nothing where there are no samples, or none to be believed.
  std::optional<Turn> between(Stamp start, Stamp end) const;
  /// Takes in the source's next motion. @param is_measured by the source's own sensor
  Status learn(const Motion& motion, bool is_measured);

  Counters counters() const { return gyro_.counters(); }
  std::uint64_t dropped() const { return gyro_.dropped(); }
  Component::Figures figures() const { return figuresOf(gyro_.calibration()); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(gyro_);
  }

 private:
  CalibratedGyro gyro_;
};

}  // namespace slam::gyro
