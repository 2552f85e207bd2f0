// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/laser_landmarks/laser_lines_config.hpp"
#include "slam_core/laser_landmarks/wall_lines.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// Finds the straight walls in the scans of a horizontal laser: what they are taken for, lines or
/// corners, says the derived class. Landmarks have no ids. Counted as in wallLinesOf().
class WallDetector : public LandmarkDetector {
 public:
  void configure(const LaserLinesConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void set(const LaserScan& scan) { next_scan_ = scan; }
  Status execute() override;
  const std::optional<LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  Counters counters() const override { return counters_; }
  void reset() override;

 protected:
  const LaserLinesConfig& config() const { return config_; }

 private:
  virtual std::vector<LandmarkObservation> landmarksOf(
      const std::vector<WallLine>& lines) const = 0;

  LaserLinesConfig config_;
  std::optional<LaserScan> next_scan_;
  std::optional<LandmarkObservationArray> observations_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

/// The walls themselves, as line landmarks.
class LaserLines final : public WallDetector {
  std::vector<LandmarkObservation> landmarksOf(const std::vector<WallLine>& lines) const override;
};

/// The corners and edges of walls of which both sides are seen, as point landmarks.
class LaserCorners final : public WallDetector {
  std::vector<LandmarkObservation> landmarksOf(const std::vector<WallLine>& lines) const override;
};

}  // namespace slam::laser_landmarks
