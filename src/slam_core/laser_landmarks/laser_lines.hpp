// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/laser_landmarks/laser_lines_config.hpp"
#include "slam_core/laser_landmarks/scan_detector.hpp"
#include "slam_core/laser_landmarks/wall_lines.hpp"

namespace slam::laser_landmarks {

/// Finds the straight walls in the scans of a horizontal laser. The derived class decides whether
/// lines or corners are the landmarks. Rejected pieces are counted as in wallLinesOf().
class WallDetector : public ScanDetector {
 public:
  void configure(const LaserLinesConfig& config);
  void configure(Settings& settings) override;

 protected:
  const LaserLinesConfig& config() const { return config_; }

 private:
  Status find(const LaserScan& scan, Observations& found, Counters& counters) override;
  virtual Observations landmarksOf(const std::vector<WallLine>& lines) const = 0;

  LaserLinesConfig config_;
};

/// The walls themselves, as line landmarks.
class LaserLines final : public WallDetector {
  Observations landmarksOf(const std::vector<WallLine>& lines) const override;
};

/// The corners of walls, convex and concave, of which both sides are seen, as point landmarks.
class LaserCorners final : public WallDetector {
  Observations landmarksOf(const std::vector<WallLine>& lines) const override;
};

}  // namespace slam::laser_landmarks
