// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beacon_ranges.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/backend_mode.hpp"
#include "slam_core/models/motion.hpp"

namespace slam_toy {

struct BeaconConfig {
  static constexpr const char* kSection = "beacon_toy";

  slam::BackendMode mode = slam::BackendMode::kSlam;
  std::vector<double> beacons;
  double gate = 10.8;
  double initial_sigma = 0.001;

  void describe(slam::Fields& fields);
  /// The beacons' positions by their ids. @throw ConfigError where the list is none of beacons
  std::map<std::uint32_t, Eigen::Vector2d> positions() const;
};

/// EKF localisation (Thrun, Burgard, Fox 2005, table 7.2) by ranges to beacons of known positions,
/// one range after the other. It builds no map, so that it offers no capability. Counted: "gated",
/// "unknown" (ranges to beacons whose position is not known).
class BeaconBackend final : public slam::Backend {
 public:
  void configure(slam::Settings& settings) override;
  void describe(slam::Ports& ports) override;

  void set(const slam::Motion& motion) { motions_.push_back(motion); }
  void set(const BeaconRanges& seen) { seen_ = seen; }
  void set(const slam::PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }

  slam::Status execute() override;

  slam::PoseEstimate pose() const override { return estimate_; }
  slam::Counters counters() const override { return counters_; }
  void reset() override;

 private:
  void predict(const slam::Motion& motion);
  void take(std::uint32_t id, double z, double sigma);
  void correct(const Eigen::Vector2d& beacon, double z, double sigma);

  BeaconConfig config_;
  std::map<std::uint32_t, Eigen::Vector2d> beacons_;  ///< their positions in the map frame, by id
  slam::PoseEstimate estimate_;
  slam::Counters counters_;

  std::vector<slam::Motion> motions_;
  std::optional<BeaconRanges> seen_;
  std::optional<slam::PoseEstimate> initial_pose_;
};

}  // namespace slam_toy
