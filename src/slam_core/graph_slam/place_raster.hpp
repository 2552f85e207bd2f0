// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/quadratic_factor.hpp"

namespace slam::graph_slam {

/// The raster counts the nodes of each place; a place is 1 m and 45 degrees wide.
class PlaceRaster {
 public:
  void add(const Pose2& pose, graph::Key node) {
    auto& place = places_[placeOf(pose)];
    if (place.count++ == 0) place.first = node;
  }
  std::size_t count(const Pose2& pose) const {
    const auto found = places_.find(placeOf(pose));
    return found == places_.end() ? 0 : found->second.count;
  }
  /// The first node of a place.
  std::optional<graph::Key> first(const Pose2& pose) const {
    const auto found = places_.find(placeOf(pose));
    if (found == places_.end()) return std::nullopt;
    return found->second.first;
  }

 private:
  struct Place {
    std::size_t count = 0;
    graph::Key first = -1;
  };
  /// Places a million of metres apart may have the same number.
  static std::uint64_t placeOf(const Pose2& pose) {
    constexpr double kEdge = 1.0, kTurn = M_PI / 4;  // [m], [rad]
    constexpr std::uint64_t kMost = 1 << 20;
    const auto cell = [](double value) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value))) % kMost;
    };
    return (cell(pose.x() / kEdge) * kMost + cell(pose.y() / kEdge)) * 16 +
           cell(pose.theta() / kTurn + 8.0);
  }

  std::unordered_map<std::uint64_t, Place> places_;  // looked up only, never iterated
};

}  // namespace slam::graph_slam
