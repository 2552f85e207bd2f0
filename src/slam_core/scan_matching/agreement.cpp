// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/agreement.hpp"

#include "slam_core/grid_map/beam_reading.hpp"

namespace slam::scan_matching {
namespace {

using grid_map::Tile;

/// Some cells beside a wall are passed by a beam or two.
constexpr int kBeamsOfSurelyFree = 2;
/// Of 255: one and a half standard deviations from an end in the map.
constexpr std::uint8_t kNear = 83;

/// Where as many beams have passed, or as few as leave a cell as free as it can be told to be.
grid_map::LogOdds surelyFree(const grid_map::BeamModel& model) {
  auto cell = grid_map::kUnseen;
  for (int i = 0; i < kBeamsOfSurelyFree; ++i) cell = model.afterMiss(cell);
  return cell;
}

}  // namespace

Agreement agreementOf(const grid_map::BeamModel& model, const grid_map::GridMap& map,
                      const grid_map::ScanPoints& scan, const Pose2& pose) {
  Agreement agreement;
  if (!scan.isOnMap(pose)) return agreement;
  const auto surely_free = surelyFree(model);
  const Pose2 in_cells = scan.inCells(pose);
  for (const auto& end : scan.ends) {
    const auto cell = grid_map::cellOf(in_cells.transform(end));
    const auto* const tile = map.tile(cell);
    if (tile == nullptr) continue;
    const auto at = Tile::at(cell);
    if (tile->likelihood[at] >= kNear)
      ++agreement.agreeing;
    else if (tile->log_odds[at] != grid_map::kUnseen && tile->log_odds[at] <= surely_free)
      ++agreement.contradicting;
  }
  return agreement;
}

}  // namespace slam::scan_matching
