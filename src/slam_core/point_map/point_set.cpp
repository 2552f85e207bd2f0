// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/point_set.hpp"

#include <cmath>

namespace slam::point_map {
namespace {

constexpr std::size_t kFirstBuckets = 1024;

}  // namespace

PointSet::PointSet(double cell) : cell_(cell), heads_(kFirstBuckets, kNone) {}

PointSet::Cell PointSet::cellOf(const Eigen::Array2d& position) const {
  return {static_cast<std::int64_t>(std::floor(position.x() / cell_)),
          static_cast<std::int64_t>(std::floor(position.y() / cell_))};
}

std::size_t PointSet::bucketOf(const Cell& cell) const {
  // the finalizer of SplitMix64 (Steele, Lea, Flood 2014): neighbours must not share buckets
  auto h =
      static_cast<std::uint64_t>(cell.x) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(cell.y);
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::size_t>(h ^ (h >> 31)) & (heads_.size() - 1);
}

void PointSet::append(const Eigen::Vector2d& position) {
  if (points_.size() >= heads_.size()) grow();
  points_.push_back({position, 1});
  cells_.push_back(cellOf(position));
  next_.push_back(kNone);
  insert(static_cast<std::uint32_t>(points_.size() - 1));
}

void PointSet::fuse(std::uint32_t point, const Eigen::Vector2d& position) {
  auto& fused = points_[point];
  ++fused.count;
  moveTo(point, fused.position + (position - fused.position) / static_cast<double>(fused.count));
}

std::uint32_t PointSet::join(std::uint32_t point, std::uint32_t other) {
  const auto [position, count] = points_[other];
  auto& joint = points_[point];
  joint.count += count;
  moveTo(point, joint.position + (position - joint.position) * static_cast<double>(count) /
                                     static_cast<double>(joint.count));
  const auto last = static_cast<std::uint32_t>(points_.size() - 1);
  remove(other);
  if (other != last) {
    remove(last);
    points_[other] = points_[last];
    cells_[other] = cells_[last];
    insert(other);
  }
  points_.pop_back();
  cells_.pop_back();
  next_.pop_back();
  return point == last ? other : point;
}

void PointSet::moveTo(std::uint32_t point, const Eigen::Vector2d& position) {
  points_[point].position = position;
  const auto cell = cellOf(position);
  if (cell == cells_[point]) return;
  remove(point);
  cells_[point] = cell;
  insert(point);
}

std::optional<std::uint32_t> PointSet::nearest(const Eigen::Vector2d& position,
                                               double radius) const {
  std::optional<std::uint32_t> best;
  double best_distance = 0.0;
  visitNear(position, radius, [&](std::uint32_t point) {
    const double distance = (points_[point].position - position).squaredNorm();
    if (best && (distance > best_distance || (distance == best_distance && point > *best))) return;
    best = point;
    best_distance = distance;
  });
  return best;
}

void PointSet::insert(std::uint32_t point) {
  auto& head = heads_[bucketOf(cells_[point])];
  next_[point] = head;
  head = point;
}

void PointSet::remove(std::uint32_t point) {
  auto* link = &heads_[bucketOf(cells_[point])];
  while (*link != point) link = &next_[*link];
  *link = next_[point];
}

void PointSet::grow() {
  heads_.assign(2 * heads_.size(), kNone);
  for (std::uint32_t point = 0; point < points_.size(); ++point) insert(point);
}

void PointSet::clear() { *this = PointSet(cell_); }

}  // namespace slam::point_map
