// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/active_path/free_space.hpp"

namespace slam::active_path {

/// What a laser at a place is expected to show.
struct View {
  double gain = 0.0;     ///< expected entropy that goes [bit m^2]: bits of cells times their area
  double heading = 0.0;  ///< of the laser for it [rad]
};

/// The expected information of a scan by casting beams over the grid (Burgard et al. 2000;
/// Stachniss, Grisetti, Burgard 2005): a beam takes the entropy of each cell that it passes and
/// that is not known, once per scan, times the probability exp(-d / unknown_way) that it came so
/// far, for a way d in cells not known. It ends at what is occupied. What is known counts nothing:
/// in sum the little that is left to learn of it would outweigh the unknown.
class ViewGain {
 public:
  struct Sensor {
    double range;          ///< [m], at most 5000 cells count
    double field_of_view;  ///< [rad]
    int rays;              ///< around the whole circle
    double unknown_way;    ///< [m]
  };

  /// @param space must outlive this
  ViewGain(const FreeSpace& space, const Sensor& sensor);

  View at(Cell viewpoint);

 private:
  double cast(Cell from, double angle);
  double entropyOf(std::int8_t percent) const;
  View bestOf(const std::vector<double>& gains) const;

  const FreeSpace& space_;
  Sensor sensor_;
  std::vector<double> entropy_;  ///< by percent [bit]
  double range_;                 ///< of a beam [cells]
  std::int64_t reach_;           ///< a square so many cells to each side holds a view
  /// Each cell of the square around the viewpoint holds the number of the view that counted it
  /// last. The square goes beyond the grid, which ends where nothing was seen yet: beams go on
  /// there.
  std::vector<std::uint32_t> seen_;
  std::uint32_t view_ = 0;
};

}  // namespace slam::active_path
