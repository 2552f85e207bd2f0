// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/laser_landmarks/beam_noise.hpp"
#include "slam_core/laser_landmarks/brightness.hpp"
#include "slam_core/laser_landmarks/laser_reflectors_config.hpp"
#include "slam_core/laser_landmarks/scan_detector.hpp"

namespace slam::laser_landmarks {

/// Finds reflectors in the scans of a horizontal laser that tells intensities: successive beams
/// that are brighter than all else, as wide as a reflector is. The landmark is the middle of a flat
/// one, the axis of a cylinder.
///
/// Counted, of bright things within max_range that are no landmark: "hidden" (something nearer is
/// beside it), "cut_off" (at an end of the sweep, or beside a beam that told nothing),
/// "too_narrow", "too_wide".
class LaserReflectors final : public ScanDetector {
 public:
  void configure(const LaserReflectorsConfig& config);
  void configure(Settings& settings) override;
  void reset() override;

 private:
  Status find(const LaserScan& scan, Observations& found, Counters& counters) override;
  std::string rejectionOf(const ScanSegment& reflector, double spacing) const;
  LandmarkObservation landmarkOf(const ScanSegment& reflector, double spacing,
                                 const BeamNoise& noise) const;
  /// Says when a laser has told no intensity at all for long.
  Status watchIntensities(bool is_known);

  LaserReflectorsConfig config_;
  int dark_scans_ = 0;  ///< since the start; below 0 once one had intensities
};

}  // namespace slam::laser_landmarks
