// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/grid_map/beam_reading.hpp"

namespace slam::scan_matching {
namespace {

using grid_map::CellIndex;

/// Logarithms are counted in whole numbers, whose sum does not depend on the order.
constexpr double kLogUnit = 1.0 / 1024.0;
/// Of an end that has nothing to do with the map, relative to the best.
constexpr double kOutlier = 0.05;
constexpr int kMostLevels = 7;  // squares of 64 cells

int wholeLog(double log) { return static_cast<int>(std::lround(log / kLogUnit)); }

std::array<int, 256> likelihoodLogs() {
  std::array<int, 256> logs;
  for (std::size_t i = 0; i < logs.size(); ++i)
    logs[i] = wholeLog(std::log((static_cast<double>(i) / 255.0 + kOutlier) / (1.0 + kOutlier)));
  return logs;
}

int logOfGaussian(double sigmas) { return wholeLog(-0.5 * sigmas * sigmas); }

/// As many that the largest squares cover the window with a few of them.
int levelsFor(std::int32_t reach) {
  int levels = 1;
  while (levels < kMostLevels && (1 << levels) <= reach) ++levels;
  return levels;
}

double furthestOf(const grid_map::ScanPoints& scan) {
  double furthest = 1.0;
  for (const auto& end : scan.ends) furthest = std::max(furthest, end.norm());
  return furthest;
}

/// So close that between two headings no end moves by much more than a cell.
double headingStep(const grid_map::ScanPoints& scan) {
  constexpr double kLeast = 0.005;
  return std::max(kLeast, 1.0 / furthestOf(scan));
}

}  // namespace

bool PlaceSearch::isWithinMemory(const grid_map::ScanPoints& scan, const SearchWindow& window) {
  constexpr double kMostCells = 1e7;  // of a raster, of which there are kMostLevels
  const double edge = 2.0 * (furthestOf(scan) + scan.cells_per_metre * window.position);
  return edge * edge <= kMostCells;
}

PlaceSearch::PlaceSearch(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                         const Pose2& middle, const SearchWindow& window)
    : middle_(middle),
      window_(window),
      cells_per_metre_(scan.cells_per_metre),
      reach_(static_cast<std::int32_t>(std::ceil(window.position * scan.cells_per_metre))),
      logs_(likelihoodLogs()) {
  if (scan.ends.empty() || !scan.isOnMap(middle) || !isWithinMemory(scan, window)) return;
  const auto ends = turn(scan);
  CellIndex least = ends.front().front(), most = least;
  for (const auto& turned : ends)
    for (const auto end : turned) {
      least = {std::min(least.x, end.x), std::min(least.y, end.y)};
      most = {std::max(most.x, end.x), std::max(most.y, end.y)};
    }
  const auto levels = levelsFor(reach_);
  const auto margin = reach_ + (1 << levels);
  pyramid_.emplace(map, CellIndex{least.x - reach_, least.y - reach_},
                   CellIndex{most.x + margin, most.y + margin}, levels);
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (const auto end : ends[i]) turned_[i].ends.push_back(pyramid_->at(end));
}

std::vector<std::vector<CellIndex>> PlaceSearch::turn(const grid_map::ScanPoints& scan) {
  const double step = headingStep(scan);
  const int count = static_cast<int>(std::ceil(window_.heading / step));
  std::vector<std::vector<CellIndex>> ends;
  for (int i = -count; i <= count; ++i) {
    const double heading = i * step;
    const double sigmas = heading / std::max(window_.heading, step);
    turned_.push_back({heading, logOfGaussian(sigmas), {}});
    const Pose2 at = scan.inCells(middle_ * Pose2(0.0, 0.0, heading));
    ends.emplace_back();
    for (const auto& end : scan.ends) ends.back().push_back(grid_map::cellOf(at.transform(end)));
  }
  return ends;
}

std::optional<Pose2> PlaceSearch::best() const { return search(std::nullopt); }

std::optional<Pose2> PlaceSearch::bestApartFrom(const Pose2& place,
                                                const SearchWindow& apart) const {
  const Eigen::Vector2d shift = cells_per_metre_ * (place.position() - middle_.position());
  return search(Exclusion{shift.x(), shift.y(), wrapAngle(place.theta() - middle_.theta()),
                          cells_per_metre_ * apart.position, apart.heading});
}

std::optional<Pose2> PlaceSearch::search(const std::optional<Exclusion>& exclusion) const {
  if (!pyramid_) return std::nullopt;
  constexpr int kNothing = std::numeric_limits<int>::min();
  const int top = pyramid_->levels() - 1;
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < turned_.size(); ++i)
    for (std::int32_t y = -reach_; y <= reach_; y += 1 << top)
      for (std::int32_t x = -reach_; x <= reach_; x += 1 << top) {
        nodes.push_back({0, i, x, y});
        nodes.back().bound = boundOf(nodes.back(), top, kNothing);
      }
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const Node& a, const Node& b) { return a.bound > b.bound; });
  Node best;
  best.bound = kNothing;
  for (const auto& node : nodes) {
    if (node.bound <= best.bound) break;  // nor is anything in those behind it
    descend(node, top, exclusion, best);
  }
  if (best.bound == kNothing) return std::nullopt;
  const double cell = 1.0 / cells_per_metre_;
  return Pose2(middle_.x() + cell * best.x, middle_.y() + cell * best.y,
               middle_.theta() + turned_[best.turned].heading);
}

void PlaceSearch::descend(const Node& node, int level, const std::optional<Exclusion>& exclusion,
                          Node& best) const {
  if (exclusion && isWithin(node, level, *exclusion)) return;
  if (level == 0) {
    best = node;
    return;
  }
  const std::int32_t half = 1 << (level - 1);
  std::array<Node, 4> children;
  std::size_t count = 0;
  for (const auto y : {node.y, node.y + half})
    for (const auto x : {node.x, node.x + half}) {
      if (x > reach_ || y > reach_) continue;  // the last squares reach beyond the window
      auto& child = children[count] = {0, node.turned, x, y};
      child.bound = boundOf(child, level - 1, best.bound);
      if (child.bound > best.bound) ++count;
    }
  std::stable_sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count),
                   [](const Node& a, const Node& b) { return a.bound > b.bound; });
  for (std::size_t i = 0; i < count; ++i)
    if (children[i].bound > best.bound) descend(children[i], level - 1, exclusion, best);
}

bool PlaceSearch::isWithin(const Node& node, int level, const Exclusion& exclusion) const {
  if (std::abs(wrapAngle(turned_[node.turned].heading - exclusion.heading)) > exclusion.angle)
    return false;
  const double edge = (1 << level) - 1;
  const double x = std::max(std::abs(node.x - exclusion.x), std::abs(node.x + edge - exclusion.x));
  const double y = std::max(std::abs(node.y - exclusion.y), std::abs(node.y + edge - exclusion.y));
  return std::hypot(x, y) <= exclusion.radius;
}

int PlaceSearch::boundOf(const Node& node, int level, int enough) const {
  const auto& turned = turned_[node.turned];
  int sum = turned.log_prior;
  if (level == 0) {
    const double sigmas = std::hypot(node.x, node.y) / std::max(1, reach_);
    sum += logOfGaussian(sigmas);
  }
  const auto* const likelihoods =
      pyramid_->level(level) + std::ptrdiff_t{node.y} * pyramid_->width() + node.x;
  for (const auto end : turned.ends) {
    sum += logs_[likelihoods[end]];
    if (sum <= enough) break;
  }
  return sum;
}

}  // namespace slam::scan_matching
