// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

#include "slam_core/common/time.hpp"
#include "slam_core/rat/view_cell.hpp"

namespace slam::rat {

/// A place in the pose cells' network [cells], which is a torus in all three directions: far apart
/// places of the world share one.
struct CellPlace {
  double x = 0.0, y = 0.0, theta = 0.0;

  bool operator==(const CellPlace& other) const {
    return x == other.x && y == other.y && theta == other.theta;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(x, y, theta);
  }
};

/// It tells where the pose cells take the robot to be, and what it sees there.
struct PoseCellState {
  Stamp stamp;
  std::uint64_t sequence = 0;
  CellPlace place;
  std::int64_t view = kNoView;  ///< the active local view cell
  /// The torus and its cells: numbers along x and y and about theta.
  int edge = 1, headings = 1;

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, sequence, place, view, edge, headings);
  }
};

/// Empty, or why the state cannot be used.
std::string faultOf(const PoseCellState& state);

/// The distance of two places on the torus, a step to the next heading counting as one to the next
/// position [cells].
double distanceOf(const CellPlace& a, const CellPlace& b, int edge, int headings);

}  // namespace slam::rat
