// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/submap.hpp"

#include <algorithm>
#include <utility>

namespace slam::graph_slam {

Submap::Submap(const grid_map::GridMapConfig& config)
    : config_(&config), map_(std::make_unique<scan_matching::ScanMap>(config)) {}

Submap::Submap(const grid_map::GridMapConfig& config, graph::Key origin, const Pose2& odom_origin,
               std::vector<graph::Key> nodes, std::vector<SharedScan> scans,
               std::vector<Pose2> poses)
    : config_(&config),
      origin_(origin),
      T_odom_origin_(odom_origin),
      places_(std::move(poses)),
      nodes_(std::move(nodes)),
      scans_(std::move(scans)) {}

Submap::Submap(std::unique_ptr<scan_matching::ScanMap> loaded, graph::Key origin,
               std::vector<Pose2> places)
    : map_(std::move(loaded)), origin_(origin), places_(std::move(places)) {}

void Submap::insert(const SharedScan& scan, const scan_matching::ScanLevels& points,
                    graph::Key node, const Pose2& pose) {
  if (origin_ < 0) {
    origin_ = node;
    T_odom_origin_ = pose;
  }
  map_->insert(points, pose);
  nodes_.push_back(node);
  places_.push_back(pose);
  scans_.push_back(scan);
}

const scan_matching::ScanMap& Submap::map() {
  if (map_) return *map_;
  constexpr double kNoMatter = 1.0;  // ends to match with a map are not needed to draw one
  map_ = std::make_unique<scan_matching::ScanMap>(*config_);
  const auto models = scan_matching::levelModels(*config_);
  for (std::size_t i = 0; i < scans_.size(); ++i)
    map_->insert(scan_matching::pointsOf(*scans_[i], models, kNoMatter), places_[i]);
  return *map_;
}

std::size_t nearestPlace(const Submap& submap, const Pose2& pose) {
  const auto distance = [&](const Pose2& place) {
    return (place.position() - pose.position()).squaredNorm();
  };
  const auto& places = submap.places();
  const auto nearest =
      std::min_element(places.begin(), places.end(),
                       [&](const Pose2& a, const Pose2& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - places.begin());
}

Anchor nearestAnchor(const Submap& submap, const Pose2& pose) {
  if (submap.isLoaded()) return {submap.origin(), submap.odomOrigin()};
  const auto nearest = nearestPlace(submap, pose);
  return {submap.nodes()[nearest], submap.places()[nearest]};
}

}  // namespace slam::graph_slam
