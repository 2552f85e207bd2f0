// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/cell_place.hpp"

#include <cmath>

namespace slam::rat {
namespace {

double around(double difference, int cells) { return std::remainder(difference, cells); }

}  // namespace

std::string faultOf(const PoseCellState& state) {
  const bool is_place = std::isfinite(state.place.x) && std::isfinite(state.place.y) &&
                        std::isfinite(state.place.theta);
  if (is_place && state.view >= kNoView && state.edge > 0 && state.headings > 0) return "";
  return "it holds no place of a network of pose cells";
}

double distanceOf(const CellPlace& a, const CellPlace& b, int edge, int headings) {
  return std::hypot(around(a.x - b.x, edge), around(a.y - b.y, edge),
                    around(a.theta - b.theta, headings));
}

}  // namespace slam::rat
