// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/models/motion.hpp"

namespace slam {

/// A piece of the way by odometry and by sensors, in the same frame [m].
struct PieceOfWay {
  Eigen::Vector2d odometry = Eigen::Vector2d::Zero();
  Eigen::Vector2d estimated = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of their difference [m^2]
};

/// Compares the way by odometry with the way that a back-end makes of it with all it sees, or that
/// the landmarks in view show alone (LandmarkMotion), over the last metres: how much longer it is,
/// and by how much it points elsewhere. Noise of the odometry makes them differ by little. Where
/// they differ by more, the wheels or the ranges have a wrong scale, the bearings an offset, or a
/// sensor repeats itself, and nothing tells which of the two ways is right. A map that is being
/// built then has a scale and a direction that may be wrong by this: the robot's position is in
/// doubt by as much as it is away from where the map began.
class ScaleDoubt {
 public:
  void add(const PieceOfWay& piece);
  /// To be called for each step instead; the steps are joined to pieces here.
  /// @param odometry since the last step, with its covariance
  /// @param estimated the back-end's increment, in the robot's frame before it
  void add(const Motion& odometry, const Pose2& estimated);

  /// The estimated way differs from the one by odometry by this.
  struct Difference {
    double scale = 0.0;  ///< by how much it is longer, as a share of the way by odometry
    double turn = 0.0;   ///< from the one to the other [rad]

    template <class Archive>
    void persist(Archive& archive) {
      archive(scale, turn);
    }
  };
  Difference difference() const { return difference_; }
  /// The same; 0 where the noise of the two ways explains it.
  Difference beyondNoise() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(odometry_, estimated_, along_, across_, square_, variance_along_, variance_across_,
            difference_);
  }

 private:
  std::optional<Motion> odometry_;  ///< of the piece of the way that is not compared yet
  Pose2 estimated_;
  double along_ = 0.0, across_ = 0.0, square_ = 0.0;     ///< sums of products of the ways [m^2]
  double variance_along_ = 0.0, variance_across_ = 0.0;  ///< of the first two [m^4]
  Difference difference_;
};

/// The covariance of the pose (x, y, heading) where the map's scale and direction are in doubt. It
/// grows with the distance from where the map began, and is not zero there: the first metre was
/// driven before anything was noticed. Errors of position and heading are independent in it, since
/// it is not known which of the two a sensor has made wrong.
/// @param from_start the robot's position in the map frame, relative to where the map began [m]
Eigen::Matrix3d covarianceOf(const ScaleDoubt::Difference& doubt,
                             const Eigen::Vector2d& from_start);

}  // namespace slam
