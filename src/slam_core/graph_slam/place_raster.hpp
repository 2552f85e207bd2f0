// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/quadratic_factor.hpp"

namespace slam::graph_slam {

/// Counts the nodes near a pose: within 1 m and 45 degrees of it. A raster finds them, but their
/// distance counts: beside a node there are no places that count as empty, however often a robot
/// comes by that never drives the same line twice.
class PlaceRaster {
 public:
  void add(const Pose2& pose, graph::Key node) {
    cells_[cellOf(pose.x(), pose.y())].push_back({pose, node, size_++});
  }
  /// The number of nodes near a pose.
  std::size_t count(const Pose2& pose) const {
    std::size_t count = 0;
    forEachNear(pose, [&](const Entry&) { ++count; });
    return count;
  }
  /// The one of them that was added first.
  std::optional<graph::Key> first(const Pose2& pose) const {
    const Entry* first = nullptr;
    forEachNear(pose, [&](const Entry& each) {
      if (first == nullptr || each.number < first->number) first = &each;
    });
    if (first == nullptr) return std::nullopt;
    return first->node;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(cells_, size_);
  }

 private:
  static constexpr double kNear = 1.0, kTurned = M_PI / 4;  // [m], [rad]

  struct Entry {
    Pose2 pose;
    graph::Key node;
    std::size_t number;  ///< in the order in which they were added

    template <class Archive>
    void persist(Archive& archive) {
      archive(pose, node, number);
    }
  };

  template <class Visit>
  void forEachNear(const Pose2& pose, const Visit& visit) const {
    for (const double dx : {-kNear, 0.0, kNear})
      for (const double dy : {-kNear, 0.0, kNear}) {
        const auto found = cells_.find(cellOf(pose.x() + dx, pose.y() + dy));
        if (found == cells_.end()) continue;
        for (const auto& each : found->second)
          if (isNear(pose.between(each.pose))) visit(each);
      }
  }
  static bool isNear(const Pose2& between) {
    return between.position().norm() <= kNear && std::abs(between.theta()) <= kTurned;
  }
  /// Cells a million of metres apart may have the same number.
  static std::uint64_t cellOf(double x, double y) {
    constexpr std::uint64_t kMost = 1 << 20;
    const auto along = [](double value) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / kNear))) %
             kMost;
    };
    return along(x) * kMost + along(y);
  }

  std::unordered_map<std::uint64_t, std::vector<Entry>> cells_;  // looked up only, never iterated
  std::size_t size_ = 0;
};

}  // namespace slam::graph_slam
