// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/models/motion.hpp"

namespace slam {

/// A piece of the path, by odometry and by sensors, in the same frame [m].
struct PieceOfWay {
  Eigen::Vector2d odometry = Eigen::Vector2d::Zero();
  Eigen::Vector2d estimated = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of their difference [m^2]
};

/// Compares the path by odometry over the last metres with the path that a back-end estimates from
/// all its data, or with the path by the landmarks in view alone (LandmarkMotion): how much longer
/// the latter is, and by which angle its direction differs. Noise of the odometry makes them differ
/// by little. If they differ by more, the wheels or the ranges have a wrong scale, the bearings
/// have an offset, or a sensor repeats itself, and it is unknown which of the two paths is right.
/// Then the scale and direction of a map that is being built may be wrong by this difference, so
/// that the doubt in the robot's position grows with its distance from where the map began.
class ScaleDoubt {
 public:
  void add(const PieceOfWay& piece);
  /// To be called for each step instead. It joins the steps to pieces.
  /// @param odometry since the last step, with its covariance
  /// @param estimated the back-end's increment, in the robot's frame before it
  void add(const Motion& odometry, const Pose2& estimated);

  /// The estimated path differs from the path by odometry in length and direction.
  struct Difference {
    double scale = 0.0;  ///< by how much it is longer, as a share of the path by odometry
    double turn = 0.0;   ///< from the one to the other [rad]

    template <class Archive>
    void persist(Archive& archive) {
      archive(scale, turn);
    }
  };
  Difference difference() const { return difference_; }
  /// The same; 0 if the noise of the two paths explains it.
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

/// The covariance of the pose (x, y, heading) if the map's scale and direction are in doubt. It
/// grows with the distance from where the map began, and is not zero there, since the first metre
/// was driven before anything was noticed. Errors of position and heading are independent in it,
/// since it is not known which of the two is wrong.
/// @param from_start the robot's position in the map frame, relative to where the map began [m]
Eigen::Matrix3d covarianceOf(const ScaleDoubt::Difference& doubt,
                             const Eigen::Vector2d& from_start);

}  // namespace slam
