// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/beam_reading.hpp"

#include <algorithm>
#include <cmath>

namespace slam::grid_map {
namespace {

constexpr double kHalfCell = 0.5;

/// The most likely surface among the cells along a beam, told one after the other from the sensor.
class MostLikelySurface {
 public:
  MostLikelySurface(const Eigen::Vector2d& end, const Eigen::Vector2d& direction, double sigma)
      : end_(end), direction_(direction), sigma_(sigma), own_(cellOf(end)) {}

  void consider(CellIndex cell, const GridMap& map) {
    const auto* const tile = map.tile(cell);
    const auto at = Tile::at(cell);
    if (tile != nullptr && BeamModel::isOccupied(tile->log_odds[at])) {
      const Eigen::Vector2d mean(cell.x + 0.5 + tile->mean_x[at] / kOffsets,
                                 cell.y + 0.5 + tile->mean_y[at] / kOffsets);
      const double log_odds = tile->log_odds[at] / kLogOddsUnit;
      const double sigmas = (mean - end_).dot(direction_) / sigma_;
      choose(cell, log_odds - 0.5 * sigmas * sigmas);
      log_passing_ -= std::log1p(std::exp(log_odds));
    } else if (cell == own_) {
      choose(cell, 0.0);
    }
  }
  CellIndex cell() const { return best_; }
  bool isKnown() const { return !(best_ == own_); }

 private:
  static constexpr double kOffsets = 256.0;

  void choose(CellIndex cell, double log_likelihood) {
    if (has_any_ && !(log_likelihood + log_passing_ > largest_)) return;
    has_any_ = true;
    best_ = cell;
    largest_ = log_likelihood + log_passing_;
  }

  const Eigen::Vector2d end_, direction_;
  const double sigma_;
  const CellIndex own_;
  CellIndex best_ = own_;
  bool has_any_ = false;
  double largest_ = 0.0;
  double log_passing_ = 0.0;  ///< of not having been stopped before
};

}  // namespace

CellIndex cellOf(const Eigen::Vector2d& point) {
  return {static_cast<std::int32_t>(std::floor(point.x())),
          static_cast<std::int32_t>(std::floor(point.y()))};
}

bool dependsOnMap(double sigma) { return BeamModel::kSigmas * sigma > kHalfCell; }

BeamReading readingOf(const Eigen::Vector2d& origin, const Eigen::Vector2d& end, double sigma,
                      const GridMap& map) {
  const CellIndex own = cellOf(end);
  const double length = (end - origin).norm();
  const double reach = std::min(BeamModel::kSigmas * sigma, length);
  if (!(reach > kHalfCell)) return {end, own, own};
  const Eigen::Vector2d direction = (end - origin) / length;
  MostLikelySurface surface(end, direction, sigma);
  CellIndex last = own;
  bool is_first = true;
  for (double along = -reach; along <= reach; along += kHalfCell) {
    const auto cell = cellOf(end + along * direction);
    if (!is_first && cell == last) continue;
    is_first = false;
    surface.consider(last = cell, map);
  }
  // where nothing was known, the surface may as well stand before the end
  return {end, surface.cell(),
          surface.isKnown() ? surface.cell() : cellOf(end - reach * direction)};
}

}  // namespace slam::grid_map
