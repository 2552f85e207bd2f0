// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "slam_core/graph_slam/names.hpp"

namespace slam::graph_slam {

/// What scans say of the path. Between nodes they tell the motion since the last one instead of
/// odometry. Where a landmark was seen from a newer node, that node hangs on the one before by
/// odometry, and the scan joins it to the reference: the last node whose scan is drawn in the
/// submap. What the errors of scans have in common so does not add up from node to node.
///
/// The odom frame is that of the scan tracker.
class ScanPath {
 public:
  /// @param path outlives this @param drift variance of the scans' motion for each metre
  /// @param iterations at most so many when a node is joined
  ScanPath(PathGraph& path, const Eigen::Vector3d& drift, int iterations)
      : path_(path), drift_(drift), iterations_(iterations) {}

  void restart();
  /// A node that is about to be removed.
  void forget(graph::Key node);
  /// Motion since the last scan, by odometry.
  void predict(const Motion& motion);
  /// Finds the last node in the odom frame, where odometry cannot.
  /// @param robot at the last scan, T_odom_base; to be called before each scan is matched
  void locate(const PoseEstimate& robot);
  /// The motion that odometry has reported since the last scan.
  std::optional<Motion> takeMotion() { return std::exchange(carried_, std::nullopt); }
  /// @param robot where the scan puts it, T_odom_base @param is_determined whether by itself
  /// @return false where no node is known in the odom frame
  bool follow(const PoseEstimate& robot, bool is_determined);
  /// The node of a scan that is drawn in the submap: the reference from now on. What later scans
  /// are off by they owe to it, so that it counts as exact in the odom frame.
  /// @param of_scan what the scan's own errors contribute to the robot's covariance
  graph::Key insert(const PoseEstimate& robot, const Eigen::Matrix3d& of_scan, bool is_determined);

  template <class Archive>
  void persist(Archive& archive) {
    archive(carried_, last_, reference_);
  }

 private:
  friend struct SessionParts;  // writes and reads its members

  /// A node of which the place among the submap's parts is known.
  struct Place {
    graph::Key node = -1;
    PoseEstimate in_odom;        ///< T_odom_base
    std::optional<Motion> told;  ///< since then, by odometry

    template <class Archive>
    void persist(Archive& archive) {
      archive(node, in_odom, told);
    }
  };

  PoseEstimate motionFrom(const Place& place, const PoseEstimate& robot) const;
  void join(const PoseEstimate& robot);
  void loosenLinks(graph::Key node, const Eigen::Vector3d& error);

  PathGraph& path_;
  Eigen::Vector3d drift_;
  int iterations_;
  std::optional<Motion> carried_;   ///< since the last scan
  std::optional<Place> last_;       ///< of the last node that had a scan
  std::optional<Place> reference_;  ///< of the last one that is drawn in the submap
};

}  // namespace slam::graph_slam
