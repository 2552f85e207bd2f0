// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <utility>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/contract/ports.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/product/observation_intake.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// Makes the triggers of a back-end fit for it: faults are taken out and counted, what the robot
/// file says of a sensor is filled in, observations are sorted by id. A trigger with a fault still
/// moves time on where its kind can be empty. Counted: the reasons of the ObservationIntake,
/// "invalid_scan", "invalid_NAME" of an input NAME of any other kind.
class InputScreen {
 public:
  /// @param takes_lines see ObservationIntake @throw ConfigError
  void configure(Settings& settings, bool takes_lines) {
    const auto sensor = settings.read<LandmarkSensorConfig>();
    const bool needs_ids = settings.read<ProductConfig>().association == "known_ids";
    observations_ = ObservationIntake(sensor, takes_lines, needs_ids);
  }

  /// When a value arrives. @return nothing where it is left out
  std::optional<HeldDatum> pass(const InputPort& port, const void* value);

  /// Whether a value has no fault; else it is counted and to be left out.
  bool isFit(const InputPort& port, const void* value);
  /// When a step takes it: what would be too much for one step is left out.
  void admit(const InputPort& port, void* value);
  /// Does the same as ObservationIntake::knowOnly().
  void knowOnly(const LandmarkMap& map) { observations_.knowOnly(map); }

  /// What was wrong with the values since the last call, as a sentence; empty where nothing was.
  std::string takeFault() { return std::exchange(fault_, ""); }
  const Counters& counters() const { return counters_; }
  void reset();

  template <class Archive>
  void persist(Archive& archive) {
    archive(observations_, fault_, counters_);
  }

 private:
  void screen(LaserScan& scan);
  void tell(const std::string& sentence);

  ObservationIntake observations_;
  std::string fault_;
  Counters counters_;
};

}  // namespace slam
