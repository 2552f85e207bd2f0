// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <utility>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// One odometry increment with its complete uncertainty: the odometry source owns the motion model,
/// back-ends add nothing. `covariance` is that of the coordinates (x, y, theta) of `increment`, the
/// pose at `end` in the robot frame at `start` [m^2, m rad, rad^2].
struct Motion {
  std::uint64_t sequence = 0;
  Stamp start, end;
  Pose2 increment;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Pose2 odometry_start, odometry_end;  ///< T_odom_base
  std::string odometry_frame, base_frame;

  template <class Archive>
  void persist(Archive& archive) {
    archive(sequence, start, end, increment, covariance, odometry_start, odometry_end,
            odometry_frame, base_frame);
  }
};

/// The parts before and after a stamp within (start, end): the increment is divided along the SE(2)
/// geodesic, a part s of the interval carries s times the covariance.
std::pair<Motion, Motion> split(const Motion& motion, Stamp at);

/// Two motions, one after the other, as one: of the same odometry, the second's where they differ.
Motion joined(const Motion& first, const Motion& second);

/// Standard deviations of an input above which it tells nothing, and its covariance is a fault:
/// what is computed from far larger ones is no number any more.
constexpr double kLargestInputSigmaLength = 1000.0;  // [m]
constexpr double kLargestInputSigmaAngle = 10.0;     // [rad]

/// Empty, or one sentence on what makes the motion unusable (NaN, an interval that is not positive,
/// a covariance that is not positive definite or absurdly large, values that no robot's odometry
/// has).
std::string faultOf(const Motion& motion);

/// Whether a robot on wheels may move like that: at 100 m/s, and 10 m more for stamps that lie.
bool isPossible(const Pose2& step, Duration interval);
/// Whether it is about where an odometry begins that was restarted.
bool isOrigin(const Pose2& pose);

/// Whether the matrix is finite, symmetric and positive definite.
bool isCovariance(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// What a motion makes of an error of the pose (x, y, theta), map frame: it goes through F (0 where
/// the pose was set anew), and odometry adds an error of covariance Q.
struct PosePrediction {
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();

  template <class Archive>
  void persist(Archive& archive) {
    archive(F, Q);
  }
};

}  // namespace slam
