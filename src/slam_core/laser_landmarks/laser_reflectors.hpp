// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/laser_landmarks/beam_noise.hpp"
#include "slam_core/laser_landmarks/brightness.hpp"
#include "slam_core/laser_landmarks/laser_reflectors_config.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// Finds reflectors in the scans of a horizontal laser that tells intensities: successive beams
/// that are brighter than all else, as wide as a reflector is. The landmark is the middle of a flat
/// one, the axis of a cylinder. Landmarks have no ids.
///
/// Counted, of bright things within max_range that are no landmark: "hidden" (something nearer is
/// beside it), "cut_off" (at an end of the sweep, or beside a beam that told nothing),
/// "too_narrow", "too_wide".
class LaserReflectors final : public LandmarkDetector {
 public:
  void configure(const LaserReflectorsConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void set(const LaserScan& scan) { next_scan_ = scan; }
  Status execute() override;
  const std::optional<LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  Counters counters() const override { return counters_; }
  void reset() override;

 private:
  void observe(const ScanSegment& reflector, double spacing, const BeamNoise& noise);
  std::string rejectionOf(const ScanSegment& reflector, double spacing) const;
  LandmarkObservation landmarkOf(const ScanSegment& reflector, double spacing,
                                 const BeamNoise& noise) const;
  /// Says when a laser has told no intensity at all for long.
  Status watchIntensities(bool is_known);

  LaserReflectorsConfig config_;
  std::optional<LaserScan> next_scan_;
  std::optional<LandmarkObservationArray> observations_;
  std::uint64_t next_sequence_ = 0;
  int dark_scans_ = 0;  ///< since the start; below 0 once one had intensities
  Counters counters_;
};

}  // namespace slam::laser_landmarks
