// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::scan_matching {

/// The likelihood of a scan at a pose in a map, parts of which may be unknown. It has a factor for
/// each end: the likelihood of the end's cell, mixed with that of an end that has nothing to do
/// with the map (the likelihood field of Thrun, Burgard, Fox 2005, ch. 6.4). In an unknown cell an
/// end is less likely than at a surface and more likely than where beams have passed.
class ScanEvidence {
 public:
  /// @param outlier likelihood of an end that has nothing to do with the map, relative to the best
  /// @param unknown likelihood of an end in an unknown cell, relative to the best
  /// @param information share of each end's information that is used, since neighbours have the
  /// same errors
  ScanEvidence(double outlier, double unknown, double information);

  /// The log-likelihood; at most 0, when all ends fit best.
  /// @param pose T_map_base
  double log(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
             const Pose2& pose) const;

 private:
  std::array<double, 256> logs_;
  double log_unknown_;
};

}  // namespace slam::scan_matching
