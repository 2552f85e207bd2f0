// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/rat/cell_place.hpp"
#include "slam_core/rat/pose_cell_config.hpp"

namespace slam::rat {

/// A continuous attractor of cells in (x, y, theta), a torus in each direction (Milford and Wyeth
/// 2008, section IV): cells excite their neighbours and inhibit those further off, so that activity
/// gathers in one packet, whose centre is where the robot takes itself to be. Motion moves it,
/// known views add to it elsewhere; of two packets the stronger one remains. All activity is 1
/// together.
class PoseCellNetwork {
 public:
  PoseCellNetwork() : PoseCellNetwork(PoseCellConfig()) {}
  /// One packet at the origin.
  explicit PoseCellNetwork(const PoseCellConfig& config);

  /// Adds activity at a place, spread over the cells around it.
  void inject(const CellPlace& place, double activity);
  /// A step of the attractor: excitation, inhibition, global inhibition, normalisation.
  void settle();
  /// The robot has moved by this much in its own frame [m, rad]: each layer of cells moves in the
  /// direction of its heading.
  void move(const Pose2& increment);

  /// Mean of the activity around the most active cell.
  CellPlace centre() const;
  double activityAt(int x, int y, int theta) const { return activity_[index(x, y, theta)]; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(activity_);
  }

 private:
  std::size_t index(int x, int y, int theta) const {
    return static_cast<std::size_t>((theta * edge_ + y) * edge_ + x);
  }
  std::vector<double> spread(const std::vector<double>& weights) const;
  void moveLayer(int theta, double dx, double dy);
  void turn(double cells);
  void normalise();

  int edge_, headings_;
  double cell_size_, global_inhibition_;
  std::vector<double> excitation_, inhibition_;  ///< weights from the middle outwards
  std::vector<double> activity_;
};

}  // namespace slam::rat
