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

/// Whether a beam has passed through what stands in the map, well before its end.
bool isStopped(const grid_map::GridMap& map, const Eigen::Vector2d& origin,
               const Eigen::Vector2d& end) {
  constexpr double kMargin = 8.0;  // [cells], beyond the noise of ends and the thickness of walls
  const double length = (end - origin).norm();
  const Eigen::Vector2d direction = (end - origin) / length;
  for (double along = kMargin; along < length - kMargin; along += 1.0)
    if (grid_map::BeamModel::isOccupied(map.logOdds(grid_map::cellOf(origin + along * direction))))
      return true;
  return false;
}

}  // namespace

Agreement agreementOf(const grid_map::BeamModel& model, const grid_map::GridMap& map,
                      const grid_map::ScanPoints& scan, const Pose2& pose) {
  Agreement agreement;
  if (!scan.isOnMap(pose)) return agreement;
  const auto surely_free = surelyFree(model);
  const Pose2 in_cells = scan.inCells(pose);
  const auto judge = [&](const Eigen::Vector2d& origin, const Eigen::Vector2d& end) {
    const auto cell = grid_map::cellOf(end);
    const auto* const tile = map.tile(cell);
    const auto at = Tile::at(cell);
    const bool is_known = tile != nullptr && tile->log_odds[at] != grid_map::kUnseen;
    if (tile != nullptr && tile->likelihood[at] >= kNear)
      ++agreement.agreeing;
    else if (is_known ? tile->log_odds[at] <= surely_free : isStopped(map, origin, end))
      ++agreement.contradicting;
    else
      ++agreement.silent;
  };
  scan.forEachFan([&](const auto& fan, const auto&, const auto& ends) {
    const Eigen::Vector2d origin = in_cells.transform(fan.origin);
    for (const auto& end : ends) judge(origin, in_cells.transform(end));
  });
  return agreement;
}

}  // namespace slam::scan_matching
