// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/camera/normalised_camera.hpp"

namespace slam::mono_graph {

/// Poses on the plane, points in space, and what joins them.
struct Bundle {
  struct View {
    Pose2 pose;  ///< T_map_base
    NormalisedCamera camera;
    bool is_fixed = false;
  };
  struct Observation {
    int view = 0, point = 0;
    Eigen::Vector2d seen = Eigen::Vector2d::Zero();  ///< on the plane z = 1
    double sigma = 1.0;                              ///< along each axis
  };
  /// Odometry between two views; the covariance is of the coordinates of the increment.
  struct Way {
    int from = 0, to = 0;
    Pose2 increment;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  };

  std::vector<View> views;
  std::vector<Eigen::Vector3d> points;  ///< [m]
  std::vector<Observation> observations;
  std::vector<Way> ways;
};

/// Moves points and views that are not fixed until the observations fit best: bundle adjustment
/// (Triggs et al. 2000) by Levenberg's and Marquardt's method, the points eliminated first (Schur's
/// complement), observations with Huber's weights.
/// @param most_steps linear systems to solve at most
void adjust(Bundle& bundle, int most_steps);

/// The squared residual of an observation in its standard deviations; large where the view does not
/// see the point at all.
double chi2Of(const Bundle& bundle, const Bundle::Observation& observation);

}  // namespace slam::mono_graph
