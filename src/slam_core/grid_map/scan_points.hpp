// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::grid_map {

/// A scan as the map takes it, in the robot's frame, lengths in cells.
struct ScanPoints {
  struct Beam {
    Eigen::Vector2d end;  ///< of what it says
    LogOdds gain;         ///< of the cell in which it ends; 0: it says that there is nothing
    double sigma;         ///< of its length; 0 where it says that there is nothing
    bool isHit() const { return gain > 0; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(end, gain, sigma);
    }
  };
  double cells_per_metre = 1.0;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< the sensor
  double relative_sigma = 0.0;                       ///< of a range, relative to it
  std::vector<Beam> beams;
  /// Ends to match with the map: of those that lie close together only some.
  std::vector<Eigen::Vector2d> ends;

  /// Whether cells have numbers there. A pose that is none, or further away, is no place on a map.
  bool isOnMap(const Pose2& pose) const;
  /// The pose with lengths in cells.
  Pose2 inCells(const Pose2& pose) const {
    return {cells_per_metre * pose.x(), cells_per_metre * pose.y(), pose.theta()};
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(cells_per_metre, origin, relative_sigma, beams, ends);
  }
};

/// Beams that are no numbers, or further than what is usable, are left out.
/// @param spacing between the ends to match [m]
ScanPoints pointsOf(const LaserScan& scan, const BeamModel& model, double spacing);

}  // namespace slam::grid_map
