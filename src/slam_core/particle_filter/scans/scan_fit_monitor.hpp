// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::particle_filter {

/// Whether scans still fit the map they are matched with: what FitMonitor is for landmarks. An end
/// where the map has nothing yet says nothing, one where it is free contradicts it. People and
/// moved chairs make some ends do so; when most do, it is the robot that is not where it should be.
class ScanFitMonitor {
 public:
  /// @param model of the beams that the map is made of
  /// @param lost_share of the ends in known cells that contradict the map
  explicit ScanFitMonitor(const grid_map::BeamModel& model, double lost_share = 0.5);

  /// To be called for each scan, before it goes into the map.
  /// @param pose T_map_base
  void judge(const grid_map::GridMap& map, const grid_map::ScanPoints& scan, const Pose2& pose);

  /// Whether the last scan, or one of the few before it, contradicted the map: the robot draws a
  /// map anew where it takes itself to be, which soon fits.
  bool isLost() const { return scans_in_doubt_ > 0; }
  /// Of the last scan's ends in known cells.
  double contradictingShare() const { return share_; }
  /// A new place or map: what was seen before says nothing of it.
  void forget();

 private:
  grid_map::LogOdds surely_free_;
  double lost_share_;
  double share_ = 0.0;
  int scans_in_doubt_ = 0;  ///< to come
};

}  // namespace slam::particle_filter
