// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::laser_odometry {

/// What a laser has seen on the last metres of a robot's way. Two maps are begun in turn: when the
/// younger one holds enough the older one is given up, so that neither memory nor errors of long
/// ago pile up.
class LocalMap {
 public:
  /// @param way of which it holds at least what was seen, and at most twice that [m]
  LocalMap(const grid_map::GridMapConfig& config, double way);

  /// To match with, until the next insert() or reset().
  scan_matching::MapView view() const { return older_->view(); }
  /// @param pose T_odom_base
  void insert(const scan_matching::ScanLevels& scan, const Pose2& pose);
  void reset();
  std::size_t bytes() const;

  template <class Archive>
  void persist(Archive& archive) {
    const auto make = [this] { return empty(); };
    archive.made(older_, make);
    archive.made(younger_, make);
    archive(gone_, last_);
  }

 private:
  std::unique_ptr<scan_matching::ScanMap> empty() const;

  grid_map::GridMapConfig config_;
  double way_;
  std::unique_ptr<scan_matching::ScanMap> older_, younger_;  ///< no younger one on the first metres
  double gone_ = 0.0;                                        ///< since the younger one began [m]
  Pose2 last_;
};

}  // namespace slam::laser_odometry
