// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace slam::active_path {

/// Where the robot has been, how certain it was there at best, and how long ago by its way.
class VisitedPlaces {
 public:
  struct Place {
    Eigen::Vector2d position;  ///< [m]
    double sigma;              ///< of the position, at best [m]
    double way;                ///< driven until the robot was there last [m]
  };

  /// The robot is here now.
  /// @param sigma of the position [m]
  void note(const Eigen::Vector2d& position, double sigma);

  const std::vector<Place>& all() const { return places_; }
  double wayDriven() const { return way_; }  ///< since the first note [m]

 private:
  std::vector<Place> places_;  ///< at least kSpacing apart
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
  double way_ = 0.0;
};

}  // namespace slam::active_path
