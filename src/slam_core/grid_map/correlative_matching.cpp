// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <vector>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/grid_map/coarse_table.hpp"
#include "slam_core/grid_map/scan_matcher.hpp"

namespace slam::grid_map {
namespace {

/// The scan from the prior's place at one heading: the cells that its ends fall in.
struct Turned {
  double heading;
  std::vector<CellIndex> ends;
};

/// A square of shifts at one heading that may hold the best.
struct Square {
  std::size_t turned;
  CellIndex shift;  ///< of its lower left corner
  double bound;     ///< nothing in it is better
};

class Lattice {
 public:
  Lattice(const MatchObjective& objective, const CorrelativeMatching::Window& window)
      : objective_(objective),
        position_(objective.scan().inCells(objective.prior()).position()),
        reach_(static_cast<std::int32_t>(
            std::ceil(window.position * objective.scan().cells_per_metre))) {
    turn(window.heading);
  }

  ScanMatch best() const {
    ScanMatch best{objective_.prior(), objective_.log(objective_.prior())};
    for (const auto& square : squares()) {
      if (!(square.bound > best.log_value)) break;  // nor is anything in those behind it
      search(square, best);
    }
    return best;
  }

 private:
  /// Headings so close that between two of them no end moves by much more than a cell.
  void turn(double window) {
    double furthest = 1.0;
    for (const auto& end : objective_.scan().ends) furthest = std::max(furthest, end.norm());
    constexpr double kLeast = 0.005;
    const double step = std::max(kLeast, 1.0 / furthest);
    const int count = static_cast<int>(std::ceil(window / step));
    for (int i = -count; i <= count; ++i) {
      Turned turned{wrapAngle(objective_.prior().theta() + i * step), {}};
      const Pose2 at(position_.x(), position_.y(), turned.heading);
      for (const auto& end : objective_.scan().ends) {
        const Eigen::Vector2d point = at.transform(end);
        turned.ends.push_back({static_cast<std::int32_t>(std::floor(point.x())),
                               static_cast<std::int32_t>(std::floor(point.y()))});
      }
      turned_.push_back(std::move(turned));
    }
  }

  /// The most promising first.
  std::vector<Square> squares() const {
    const auto table = coarseTable();
    std::vector<Square> squares;
    for (std::size_t i = 0; i < turned_.size(); ++i)
      for (std::int32_t y = -reach_; y <= reach_; y += CoarseTable::kSize)
        for (std::int32_t x = -reach_; x <= reach_; x += CoarseTable::kSize)
          squares.push_back({i, {x, y}, bound(turned_[i], {x, y}, table)});
    std::stable_sort(squares.begin(), squares.end(),
                     [](const Square& a, const Square& b) { return a.bound > b.bound; });
    return squares;
  }

  CoarseTable coarseTable() const {
    CellIndex least = turned_.front().ends.front(), most = least;
    for (const auto& turned : turned_)
      for (const auto end : turned.ends) {
        least = {std::min(least.x, end.x), std::min(least.y, end.y)};
        most = {std::max(most.x, end.x), std::max(most.y, end.y)};
      }
    const auto margin = reach_ + CoarseTable::kSize;
    return CoarseTable(objective_.map(), {least.x - margin, least.y - margin},
                       {most.x + margin, most.y + margin});
  }

  double bound(const Turned& turned, CellIndex shift, const CoarseTable& table) const {
    double sum = 0.0;
    for (const auto end : turned.ends)
      sum += objective_.likelihood().log(table.at({end.x + shift.x, end.y + shift.y}));
    // the prior's density at this heading and the best place for it
    const double error = wrapAngle(turned.heading - objective_.prior().theta());
    const double sigmas = error / objective_.sigma().z();
    return sum - 0.5 * sigmas * sigmas;
  }

  void search(const Square& square, ScanMatch& best) const {
    const auto& turned = turned_[square.turned];
    // the last square of a row or column reaches beyond the window
    const auto most_x = std::min(square.shift.x + CoarseTable::kSize - 1, reach_);
    const auto most_y = std::min(square.shift.y + CoarseTable::kSize - 1, reach_);
    for (std::int32_t y = square.shift.y; y <= most_y; ++y)
      for (std::int32_t x = square.shift.x; x <= most_x; ++x) {
        const ScanMatch match = at(turned, {x, y});
        if (match.log_value > best.log_value) best = match;
      }
  }

  ScanMatch at(const Turned& turned, CellIndex shift) const {
    const double cell = 1.0 / objective_.scan().cells_per_metre;
    const auto& prior = objective_.prior();
    const Pose2 pose(prior.x() + cell * shift.x, prior.y() + cell * shift.y, turned.heading);
    double sum = objective_.logPrior(pose);
    for (const auto end : turned.ends) {
      const CellIndex there{end.x + shift.x, end.y + shift.y};
      const auto* const tile = objective_.map().tile(there);
      sum += objective_.likelihood().log(tile == nullptr ? std::uint8_t{0}
                                                         : tile->likelihood[Tile::at(there)]);
    }
    return {pose, sum};
  }

  const MatchObjective& objective_;
  Eigen::Vector2d position_;  ///< of the prior, in cells
  std::int32_t reach_;
  std::vector<Turned> turned_;
};

}  // namespace

ScanMatch CorrelativeMatching::match(const MatchObjective& objective) const {
  const auto climbed = climbing_.match(objective);
  if (objective.scan().ends.empty() || !objective.scan().isOnMap(objective.prior())) return climbed;
  const auto found = climbing_.from(Lattice(objective, window_).best().pose, objective);
  return found.log_value > climbed.log_value ? found : climbed;
}

}  // namespace slam::grid_map
