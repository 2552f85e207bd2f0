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

/// Finds reflectors in the scans of a horizontal laser that reports intensities: successive bright
/// beams (Brightness) that together are as wide as a reflector. The landmark is the middle of a
/// flat reflector or the axis of a cylindrical one.
///
/// Bright objects within max_range that are no landmark are counted: "hidden" (a nearer object is
/// beside it), "cut_off" (at an end of the sweep, or beside a beam without a reading),
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
  /// @return a warning where the laser has not reported any intensity for many scans
  Status watchIntensities(bool is_known);

  LaserReflectorsConfig config_;
  int dark_scans_ = 0;  ///< scans without intensities so far; below 0 once a scan had some
};

}  // namespace slam::laser_landmarks
