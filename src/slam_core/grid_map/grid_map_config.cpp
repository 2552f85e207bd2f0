// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_map_config.hpp"

#include <cmath>

#include "slam_core/grid_map/tile.hpp"

namespace slam::grid_map {

void GridMapConfig::describe(Fields& fields) {
  fields.add("resolution", &resolution, "edge of a cell").unit("m").in(Range::closed(0.005, 1.0));
  fields
      .add("usable_range", &usable_range,
           "what a beam meets further away is not mapped and not matched")
      .unit("m")
      .in(Range{0, 1000, true, false});
  fields
      .add("free_range", &free_range,
           "up to here a beam that met nothing tells that there is nothing; 0: it tells nothing, "
           "as of lasers that glass and black cloth do not return to")
      .unit("m")
      .in(Range::atLeast(0));
  fields
      .add("hit_probability", &hit_probability,
           "that a cell is occupied in which a beam has ended, knowing nothing else")
      .unit("1")
      .in(Range::open(0.5, 1));
  fields
      .add("miss_probability", &miss_probability,
           "that a cell is occupied which a beam has passed, knowing nothing else")
      .unit("1")
      .in(Range::open(0, 0.5));
  fields
      .add(
          "largest_probability", &largest_probability,
          "a cell's probability stays between one minus this and this, so that what has changed is "
          "seen soon")
      .unit("1")
      .in(Range::open(0.5, 0.9995));
  fields.add("sigma", &sigma, "standard deviation of the distance of a beam's end from what it met")
      .unit("m")
      .in(Range{0, 0.5, true, false});
  fields
      .add("largest_area", &largest_area,
           "of the rectangle that holds the map; what lies beyond is not mapped")
      .unit("m^2")
      .in(Range{0, 1e8, true, false});
  fields
      .add(
          "largest_memory", &largest_memory,
          "for the map, or those of all particles together; before they need more they are kept as "
          "they are")
      .unit("MB")
      .in(Range::above(0));
}

std::size_t mostTiles(const GridMapConfig& config) {
  const double edge = Tile::kSize * config.resolution;
  return static_cast<std::size_t>(std::ceil(config.largest_area / (edge * edge)));
}

bool isWithinMemory(double bytes, const GridMapConfig& config) {
  constexpr double kMegabyte = 1e6;
  return bytes <= kMegabyte * config.largest_memory;
}

}  // namespace slam::grid_map
