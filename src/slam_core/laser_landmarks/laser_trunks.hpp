// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/laser_landmarks/cylinder_fit.hpp"
#include "slam_core/laser_landmarks/laser_trunks_config.hpp"
#include "slam_core/laser_landmarks/scan_detector.hpp"
#include "slam_core/laser_landmarks/scan_segments.hpp"

namespace slam::laser_landmarks {

/// Finds upright cylinders in the scans of a horizontal laser: trunks of trees, poles, pillars. A
/// scan is cut where ranges jump; what is wide enough, thin enough and not hidden at either side is
/// a landmark where a circle fits it (Guivant, Nebot 2001). Its descriptor is the radius [m].
///
/// Segments within max_range that are no landmark are counted: "few_points", "hidden" (a nearer
/// object is beside it), "cut_off" (at an end of the sweep, or beside a beam without a reading),
/// "too_thin", "too_thick", "no_circle".
class LaserTrunks final : public ScanDetector {
 public:
  void configure(const LaserTrunksConfig& config);
  void configure(Settings& settings) override;
  LandmarkTraits traits() const override { return {true}; }

 private:
  Status find(const LaserScan& scan, Observations& found, Counters& counters) override;
  /// The trunk that a segment belongs to. If there is none, the reason is counted.
  std::optional<Cylinder> trunkOf(const ScanSegment& segment, double spacing,
                                  const BeamNoise& noise, Counters& counters) const;
  /// The reason why a segment is no trunk, judged before a circle is fitted; empty if it may be
  /// one.
  std::string rejectionOf(const ScanSegment& segment, double spacing) const;
  std::string rejectionOf(const std::optional<Cylinder>& trunk) const;

  LaserTrunksConfig config_;
};

}  // namespace slam::laser_landmarks
