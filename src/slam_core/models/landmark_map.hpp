// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam {

/// A Gaussian over the robot's pose in the map frame.
struct PoseEstimate {
  Pose2 pose;                                            ///< T_map_base
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta)

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose, covariance);
  }
};

/// Standard deviations of a pose above which back-ends would compute with differences of numbers
/// that are too large for them.
constexpr double kLargestSigmaPosition = 1000.0;  // [m]
constexpr double kLargestSigmaHeading = M_PI;     // [rad]
/// The same of (x, y, theta).
inline Eigen::Vector3d largestSigmas() {
  return {kLargestSigmaPosition, kLargestSigmaPosition, kLargestSigmaHeading};
}

/// The estimate with no more doubt than these standard deviations of (x, y, theta); what is
/// correlated stays so.
PoseEstimate bounded(PoseEstimate estimate, const Eigen::Vector3d& largest_sigmas);

/// A landmark with its marginal covariance in the map frame. Of a line, `position` is a point of
/// it.
struct Landmark {
  LandmarkId id = kUnknownId;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  /// A point has the covariance of (x, y) [m^2], a line that of its offset along the perpendicular
  /// at `position` and of its direction [m^2, m rad, rad^2].
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  LandmarkKind kind = LandmarkKind::kPoint;
  double direction = 0.0;  ///< of the perpendicular to a line, away from who saw it [rad]
  LineExtent extent = {};  ///< of a line, from `position`
  /// It is the mean over all observations of the landmark; it is empty where they have none.
  Descriptor descriptor = {};

  bool isLine() const { return kind == LandmarkKind::kLine; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(id, position, covariance, kind, direction, extent, descriptor);
  }
};

/// Landmarks sorted by id.
using LandmarkMap = std::vector<Landmark>;

/// What is saved and loaded: the map, the pose, and where the back-end has it the joint covariance
/// of (pose, landmarks in order), size 3 + 2 N; else an empty matrix.
struct MapState {
  PoseEstimate robot;
  LandmarkMap landmarks;
  Eigen::MatrixXd joint_covariance;
  std::optional<OccupancyGrid> grid = std::nullopt;  ///< of back-ends that make one

  template <class Archive>
  void persist(Archive& archive) {
    archive(robot, landmarks, joint_covariance, grid);
  }
};

/// The map without its lines, for those who take points only.
LandmarkMap pointsOf(LandmarkMap map);
MapState withoutLines(const MapState& map);

}  // namespace slam
