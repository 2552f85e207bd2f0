// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam::eval {

/// A measurement of the pose b in the frame of the pose a.
struct PoseEdge {
  int a = 0, b = 0;  ///< numbers of poses
  Pose2 z;
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< of (x, y, theta) [m, rad]
  bool is_false = false;                                      ///< addFalseLoops() has added it

  int older() const { return std::min(a, b); }
  int newer() const { return std::max(a, b); }
  bool isLoop() const { return newer() - older() != 1; }
  /// z^-1 a^-1 b, the error of the measurement, for these poses.
  Pose2 error(const Pose2& pose_a, const Pose2& pose_b) const {
    return z.inverse() * pose_a.between(pose_b);
  }
  /// Where the measurement puts its newer pose.
  Pose2 placed(const Pose2& older_pose) const { return older_pose * (a < b ? z : z.inverse()); }
};

/// A graph of poses, numbered in the order in which a robot came to them: each but the first has
/// an edge that is not false to an earlier one.
struct PoseGraph {
  std::string name;
  std::vector<std::int64_t> ids;  ///< of the poses in the file
  Pose2 start;                    ///< of the first pose
  std::vector<PoseEdge> edges;
  std::vector<Pose2> truth;             ///< of each pose; empty where it is not known
  std::map<std::string, int> left_out;  ///< records of the file by their types

  std::size_t size() const { return ids.size(); }
};

/// Keeps the first poses, and the edges between them.
void keepFirst(PoseGraph& graph, std::size_t poses);

/// The edges of each pose to earlier poses.
std::vector<std::vector<PoseEdge>> edgesByPose(const PoseGraph& graph);

/// The edge that says where a pose is before anything is solved: the one to the latest of the
/// earlier poses. @pre one of the edges is not false
const PoseEdge& placingEdge(const std::vector<PoseEdge>& edges);

/// Where the poses are by these edges alone.
std::vector<Pose2> deadReckoning(const PoseGraph& graph);

/// The sum of e^T R^-1 e over all edges.
double chi2(const PoseGraph& graph, const std::vector<Pose2>& poses);

}  // namespace slam::eval
