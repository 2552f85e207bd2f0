// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/grid_map/beam_reading.hpp"

namespace slam::scan_matching {

ScanEvidence::ScanEvidence(double outlier, double unknown, double information)
    : log_unknown_(information * std::log(unknown)) {
  for (std::size_t i = 0; i < logs_.size(); ++i)
    logs_[i] = information * std::log((static_cast<double>(i) / 255.0 + outlier) / (1.0 + outlier));
}

double ScanEvidence::log(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                         const Pose2& pose) const {
  using grid_map::Tile;
  if (!scan.isOnMap(pose)) return log_unknown_ * static_cast<double>(scan.ends.size());
  const Pose2 in_cells = scan.inCells(pose);
  double sum = 0.0;
  for (const auto& end : scan.ends) {
    const auto cell = grid_map::cellOf(in_cells.transform(end));
    const auto* const tile = map.tile(cell);
    if (tile == nullptr) {
      sum += log_unknown_;
      continue;
    }
    const auto at = Tile::at(cell);
    const double log = logs_[tile->likelihood[at]];
    const bool is_unknown = tile->log_odds[at] == grid_map::kUnseen;
    sum += is_unknown ? std::max(log, log_unknown_) : log;
  }
  return sum;
}

}  // namespace slam::scan_matching
