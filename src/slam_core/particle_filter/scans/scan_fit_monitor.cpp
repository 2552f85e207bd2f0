// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_fit_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace slam::particle_filter {
namespace {

using grid_map::Tile;

/// Ends in known cells of which something can be told.
constexpr int kEnough = 20;
/// Scans for which doubt lasts.
constexpr int kLasting = 5;
/// Some cells beside a wall are passed by a beam or two.
constexpr int kBeamsOfSurelyFree = 3;
/// Of 255: two standard deviations from an end in the map.
constexpr std::uint8_t kNear = 34;

struct Counts {
  int agreeing = 0, contradicting = 0;
};

/// Where as many beams have passed, or as few as leave a cell as free as it can be told to be.
grid_map::LogOdds surelyFree(const grid_map::BeamModel& model) {
  auto cell = grid_map::kUnseen;
  for (int i = 0; i < kBeamsOfSurelyFree; ++i) cell = model.afterMiss(cell);
  return cell;
}

void count(const grid_map::GridMap& map, const Eigen::Vector2d& end, grid_map::LogOdds surely_free,
           Counts& counts) {
  const grid_map::CellIndex cell{static_cast<std::int32_t>(std::floor(end.x())),
                                 static_cast<std::int32_t>(std::floor(end.y()))};
  const auto* const tile = map.tile(cell);
  if (tile == nullptr) return;
  const auto at = Tile::at(cell);
  if (tile->likelihood[at] >= kNear)
    ++counts.agreeing;
  else if (tile->log_odds[at] != grid_map::kUnseen && tile->log_odds[at] <= surely_free)
    ++counts.contradicting;
}

}  // namespace

ScanFitMonitor::ScanFitMonitor(const grid_map::BeamModel& model, double lost_share)
    : surely_free_(surelyFree(model)), lost_share_(lost_share) {}

void ScanFitMonitor::judge(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                           const Pose2& pose) {
  scans_in_doubt_ = std::max(0, scans_in_doubt_ - 1);
  share_ = 0.0;
  if (!scan.isOnMap(pose)) return;
  Counts counts;
  const Pose2 in_cells = scan.inCells(pose);
  for (const auto& end : scan.ends) count(map, in_cells.transform(end), surely_free_, counts);
  const int known = counts.agreeing + counts.contradicting;
  if (known < kEnough) return;
  share_ = static_cast<double>(counts.contradicting) / known;
  if (share_ > lost_share_) scans_in_doubt_ = kLasting;
}

void ScanFitMonitor::forget() {
  share_ = 0.0;
  scans_in_doubt_ = 0;
}

}  // namespace slam::particle_filter
