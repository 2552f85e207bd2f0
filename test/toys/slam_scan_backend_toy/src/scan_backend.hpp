// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <slam_scan_odometry_toy/scan_alignment.hpp>
#include <string>
#include <vector>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/backend_mode.hpp"

namespace slam_toy {

struct ScanBackendConfig {
  static constexpr const char* kSection = "scan_toy";

  slam::BackendMode mode = slam::BackendMode::kSlam;
  double key_distance = 0.4;
  double initial_sigma = 0.001;

  void describe(slam::Fields& fields);
};

/// A back-end without motion: each scan is aligned with the nearest of the key scans, and becomes
/// one itself where that is far away. Scans are all its time; where one cannot be aligned the robot
/// is taken to go on at its velocity. Of a map it offers nothing. Counted: "coasted".
class ScanBackend final : public slam::Backend {
 public:
  void configure(slam::Settings& settings) override;
  void describe(slam::Ports& ports) override;

  void set(const slam::LaserScan& scan) { scan_ = scan; }
  void set(const slam::PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }

  slam::Status execute() override;

  slam::PoseEstimate pose() const override { return estimate_; }
  slam::Counters counters() const override { return counters_; }
  Figures figures() const override { return {{"key scans", double(keys_.size())}}; }
  void reset() override;

 private:
  struct KeyScan {
    slam::PoseEstimate place;
    Points points;
  };

  /// Null where there is none yet.
  const KeyScan* nearestTo(const slam::Pose2& pose) const;
  /// Whether the last scan becomes one. @param nearest of those that there are
  bool isKey(const KeyScan* nearest, bool is_aligned) const;
  double distance(const slam::Pose2& a, const slam::Pose2& b) const;
  slam::Status take(const slam::LaserScan& scan);

  ScanBackendConfig config_;
  slam::PoseEstimate estimate_;
  std::vector<KeyScan> keys_;
  std::optional<slam::Stamp> last_;                  ///< of the last scan
  Eigen::Vector3d twist_ = Eigen::Vector3d::Zero();  ///< [m/s, m/s, rad/s]
  slam::Counters counters_;

  std::optional<slam::LaserScan> scan_;
  std::optional<slam::PoseEstimate> initial_pose_;
};

}  // namespace slam_toy
