// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::scan_matching {

/// How the ends of a scan's beams fit a map. An end near a surface agrees with the map. An end
/// where beams have passed contradicts it, and so does an end in an unknown cell whose beam passed
/// through a surface. All other ends are silent: those in unknown cells, and those in known cells
/// that are neither near a surface nor certainly free.
struct Agreement {
  int agreeing = 0, contradicting = 0;
  int silent = 0;  ///< ends that neither agree nor contradict

  int known() const { return agreeing + contradicting; }
  int surplus() const { return agreeing - contradicting; }
  /// contradicting / (agreeing + contradicting); 0 if these are fewer than 10.
  double contradictingShare() const {
    constexpr int kEnough = 10;
    return known() < kEnough ? 0.0 : static_cast<double>(contradicting) / known();
  }
  /// Whether the scan contradicts the map so much that it does not show where the robot is.
  bool mostlyContradicts() const { return contradictingShare() > 0.5; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(agreeing, contradicting, silent);
  }
};

/// @param model of the beams of which the map was made
/// @param pose T_map_base
Agreement agreementOf(const grid_map::BeamModel& model, const grid_map::GridMap& map,
                      const grid_map::ScanPoints& scan, const Pose2& pose);

}  // namespace slam::scan_matching
