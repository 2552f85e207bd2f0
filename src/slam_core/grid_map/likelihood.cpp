// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/likelihood.hpp"

#include <algorithm>

namespace slam::grid_map {
namespace {

/// Raises the likelihood of the cells of a rectangle to what an end in `cell` gives them.
void raise(const BeamModel& model, CellIndex cell, std::int8_t mean_x, std::int8_t mean_y,
           CellIndex least, CellIndex most, GridMap& map) {
  constexpr float kOne = 255.0f;
  const int reach = model.reach();
  const std::int32_t x0 = std::max(least.x, cell.x - reach), x1 = std::min(most.x, cell.x + reach);
  const std::int32_t y0 = std::max(least.y, cell.y - reach), y1 = std::min(most.y, cell.y + reach);
  for (std::int32_t y = y0; y <= y1; ++y) {
    const float along_y = kOne * model.alongAxis(y - cell.y, mean_y);
    Tile* tile = nullptr;
    for (std::int32_t x = x0; x <= x1; ++x) {
      if (tile == nullptr || (x & (Tile::kSize - 1)) == 0) tile = map.ownTile({x, y});
      if (tile == nullptr) continue;
      const auto value =
          static_cast<std::uint8_t>(along_y * model.alongAxis(x - cell.x, mean_x) + 0.5f);
      auto& likelihood = tile->likelihood[Tile::at({x, y})];
      likelihood = std::max(likelihood, value);
    }
  }
}

}  // namespace

void giveLikelihood(const BeamModel& model, CellIndex cell, GridMap& map) {
  const auto* const tile = map.tile(cell);
  const auto at = Tile::at(cell);
  const int reach = model.reach();
  raise(model, cell, tile->mean_x[at], tile->mean_y[at], {cell.x - reach, cell.y - reach},
        {cell.x + reach, cell.y + reach}, map);
}

void takeLikelihood(const BeamModel& model, CellIndex cell, GridMap& map) {
  const int reach = model.reach();
  const CellIndex least{cell.x - reach, cell.y - reach}, most{cell.x + reach, cell.y + reach};
  for (std::int32_t y = least.y; y <= most.y; ++y)
    for (std::int32_t x = least.x; x <= most.x; ++x)
      if (auto* const tile = map.ownTile({x, y})) tile->likelihood[Tile::at({x, y})] = 0;
  for (std::int32_t y = least.y - reach; y <= most.y + reach; ++y)
    for (std::int32_t x = least.x - reach; x <= most.x + reach; ++x) {
      const auto* const tile = map.tile({x, y});
      const auto at = Tile::at({x, y});
      if (tile != nullptr && BeamModel::isOccupied(tile->log_odds[at]))
        raise(model, {x, y}, tile->mean_x[at], tile->mean_y[at], least, most, map);
    }
}

}  // namespace slam::grid_map
