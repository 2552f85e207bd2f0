// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "slam_core/graph/quadratic_factor.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::graph_slam {

/// A scan that nobody changes any more, shared by all that draw it.
using SharedScan = std::shared_ptr<const LaserScan>;

/// What a laser has seen on some metres of the way, drawn in the odometry frame of the scans: a
/// rigid piece of the map that hangs on its first node. The drawing can be given up and is made
/// again of the scans, to the bit, when it is needed.
class Submap {
 public:
  /// @param config outlives this
  explicit Submap(const grid_map::GridMapConfig& config);
  /// One that was saved. @param nodes of the scans @param poses T_odom_base of the scans
  Submap(const grid_map::GridMapConfig& config, graph::Key origin, const Pose2& odom_origin,
         std::vector<graph::Key> nodes, std::vector<SharedScan> scans, std::vector<Pose2> poses);
  /// A map that was loaded; it is never given up.
  /// @param places where a robot could have been
  Submap(std::unique_ptr<scan_matching::ScanMap> loaded, graph::Key origin,
         std::vector<Pose2> places);

  /// @param points of the scan @param node of the scan @param pose T_odom_base
  void insert(const SharedScan& scan, const scan_matching::ScanLevels& points, graph::Key node,
              const Pose2& pose);
  bool isEmpty() const { return places_.empty(); }
  /// Draws it where it is not drawn.
  const scan_matching::ScanMap& map();
  void giveUpDrawing() { map_.reset(); }
  bool isLoaded() const { return config_ == nullptr; }
  std::size_t bytes() const { return map_ ? map_->bytes() : 0; }  ///< of the drawing

  /// The node of its first scan, or the variable of a loaded grid; -1 where there is none yet.
  graph::Key origin() const { return origin_; }
  /// Where that was drawn.
  const Pose2& odomOrigin() const { return T_odom_origin_; }
  /// Where a robot could have been in the grid that was loaded, then T_odom_base of the scans.
  const std::vector<Pose2>& places() const { return places_; }
  friend const std::vector<SharedScan>& scansOf(const Submap& submap) { return submap.scans_; }
  /// The nodes of its scans.
  const std::vector<graph::Key>& nodes() const { return nodes_; }

  /// What was drawn of scans is drawn again.
  template <class Archive>
  void persist(Archive& archive, const grid_map::GridMapConfig& config) {
    bool is_loaded = isLoaded(), is_drawn = map_ != nullptr;
    archive(is_loaded, is_drawn, origin_, T_odom_origin_, places_, nodes_, scans_);
    if constexpr (Archive::kReads) {
      config_ = is_loaded ? nullptr : &config;
      map_.reset();
    }
    if (is_loaded)
      archive.made(map_, [&] { return std::make_unique<scan_matching::ScanMap>(config); });
    else if (is_drawn)
      map();
  }

 private:
  const grid_map::GridMapConfig* config_ = nullptr;
  std::unique_ptr<scan_matching::ScanMap> map_;
  graph::Key origin_ = -1;
  Pose2 T_odom_origin_;
  std::vector<Pose2> places_;
  std::vector<graph::Key> nodes_;
  std::vector<SharedScan> scans_;
};

/// A node on which a submap hangs, and where it was drawn.
struct Anchor {
  graph::Key node;
  Pose2 pose;  ///< T_odom_base of a scan, T_odom_origin of a loaded grid
};

/// @param pose T_odom_base @pre the submap is not empty
/// @return which of its places() is the nearest one
std::size_t nearestPlace(const Submap& submap, const Pose2& pose);
/// @return the node of the scan that was taken nearest to this pose, or the variable of a loaded
/// grid
Anchor nearestAnchor(const Submap& submap, const Pose2& pose);

}  // namespace slam::graph_slam
