// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace slam::point_map {

/// A point of the map: the mean of the end points fused into it.
struct MapPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< in the map frame [m]
  std::uint32_t count = 1;                             ///< end points

  template <class Archive>
  void persist(Archive& archive) {
    archive(position, count);
  }
};

/// The points of a map with an index over their places: a hash of square cells, each with a list of
/// its points. Searching costs the points nearby, whatever the map's size.
class PointSet {
 public:
  /// @param cell edge of an indexed cell [m]; best about as large as the radii searched
  explicit PointSet(double cell = 0.2);

  const std::vector<MapPoint>& points() const { return points_; }
  std::size_t size() const { return points_.size(); }

  void append(const Eigen::Vector2d& position);
  /// Moves the point to the mean of all that was fused into it, `position` included.
  void fuse(std::uint32_t point, const Eigen::Vector2d& position);

  /// Joins two points to the mean of all that was fused into both. The last point takes the index
  /// of `other`.
  /// @return the joint point's index
  std::uint32_t join(std::uint32_t point, std::uint32_t other);

  /// The point nearest to a position, at most `radius` [m] away; of several the first appended.
  std::optional<std::uint32_t> nearest(const Eigen::Vector2d& position, double radius) const;

  /// Calls `visit(point)` for all within `radius` [m] of a position.
  template <class Visit>
  void visitNear(const Eigen::Vector2d& position, double radius, Visit&& visit) const {
    const auto low = cellOf(position.array() - radius), high = cellOf(position.array() + radius);
    for (auto x = low.x; x <= high.x; ++x)
      for (auto y = low.y; y <= high.y; ++y)
        for (auto point = heads_[bucketOf({x, y})]; point != kNone; point = next_[point])
          if (cells_[point] == Cell{x, y} &&
              (points_[point].position - position).squaredNorm() <= radius * radius)
            visit(point);
  }

  void clear();

  template <class Archive>
  void persist(Archive& archive) {
    archive(points_, cells_, next_, heads_);
  }

 private:
  struct Cell {
    std::int64_t x, y;
    bool operator==(const Cell& other) const { return x == other.x && y == other.y; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(x, y);
    }
  };
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  Cell cellOf(const Eigen::Array2d& position) const;
  std::size_t bucketOf(const Cell& cell) const;
  void insert(std::uint32_t point);
  void moveTo(std::uint32_t point, const Eigen::Vector2d& position);
  void remove(std::uint32_t point);
  void grow();

  double cell_;
  std::vector<MapPoint> points_;
  std::vector<Cell> cells_;          ///< of each point
  std::vector<std::uint32_t> next_;  ///< of each point: the next one of its bucket
  std::vector<std::uint32_t> heads_;
};

}  // namespace slam::point_map
