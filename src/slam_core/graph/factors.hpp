// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/factor.hpp"

namespace slam::graph {

// A weight W is a square root of an information matrix, W^T W = R^-1.
Eigen::MatrixXd weightOfInformation(const Eigen::MatrixXd& information);
/// The squares of a micrometre and of a microradian are added to the variances. Otherwise
/// information that is larger than that of other factors by more than the digits of a double would
/// erase theirs by rounding.
/// @param covariance positive definite, except for rounding errors
Eigen::MatrixXd weightOfCovariance(const Eigen::MatrixXd& covariance);

/// A pose is known: r = W (T_known^-1 T_map_base), the error as (x, y, theta).
class PosePrior final : public Factor {
 public:
  PosePrior(Key pose, const Pose2& known, const Eigen::Matrix3d& W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const Pose2& known() const { return known_; }
  const Eigen::Matrix3d& weight() const { return W_; }

 private:
  Pose2 known_, known_inverse_;
  Eigen::Matrix3d W_;
};

/// A point is known [m].
class PointPrior final : public Factor {
 public:
  PointPrior(Key point, const Eigen::Vector2d& known, const Eigen::Matrix2d& W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const Eigen::Vector2d& known() const { return known_; }
  const Eigen::Matrix2d& weight() const { return W_; }

 private:
  Eigen::Vector2d known_;
  Eigen::Matrix2d W_;
};

/// A pose and some points are known together: r = W e, where e has the pose's error as (x, y,
/// theta) in the known pose's frame, then those of the points in the map frame [m].
class JointPrior final : public Factor {
 public:
  /// @param keys that of the pose first
  JointPrior(std::vector<Key> keys, const Pose2& pose, std::vector<Eigen::Vector2d> points,
             Eigen::MatrixXd W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const Pose2& pose() const { return pose_; }
  const std::vector<Eigen::Vector2d>& points() const { return points_; }
  const Eigen::MatrixXd& weight() const { return W_; }

 private:
  Pose2 pose_, pose_inverse_;
  std::vector<Eigen::Vector2d> points_;
  Eigen::MatrixXd W_;
};

/// The pose b is known relative to a: r = W (T_ab^-1 a^-1 b), the error as (x, y, theta), as in g2o
/// (Kuemmerle, Grisetti, Strasdat, Konolige, Burgard 2011).
class Between final : public Factor {
 public:
  Between(Key a, Key b, const Pose2& a_b, const Eigen::Matrix3d& W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const Pose2& measured() const { return a_b_; }
  const Eigen::Matrix3d& weight() const { return W_; }

 private:
  Pose2 a_b_, b_a_;
  Eigen::Matrix3d W_;
};

/// Range [m] and bearing [rad] of a point from a sensor on the robot, Eq. 5.3.
class RangeBearing final : public Factor {
 public:
  RangeBearing(Key pose, Key point, const Pose2& base_sensor, const Eigen::Vector2d& z,
               const Eigen::Matrix2d& W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const Pose2& sensor() const { return base_sensor_; }
  const Eigen::Vector2d& measured() const { return z_; }
  const Eigen::Matrix2d& weight() const { return W_; }

 private:
  Pose2 base_sensor_;
  Eigen::Vector2d z_;
  Eigen::Matrix2d W_;
};

}  // namespace slam::graph
