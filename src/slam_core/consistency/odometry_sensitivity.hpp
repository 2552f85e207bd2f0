// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// How prediction and its covariance would change with the noise of the odometry, theta being the
/// share that its variance is larger than believed: d = dP/dtheta, e = dx/dtheta, for the pose
/// (x, y, theta) relative to the landmarks. A filter that believes its odometry too much lags
/// behind: what it errs at one step shows at the next ones, so e tells far more of odometry that
/// is a little worse than it says than a single step does (Gupta and Mehra 1974, the sensitivity
/// equations of the Kalman filter, here of the pose alone).
class OdometrySensitivity {
 public:
  const Eigen::Vector3d& mean() const { return e_; }
  const Eigen::Matrix3d& covariance() const { return D_; }

  void predict(const PosePrediction& prediction);
  /// @param group with H
  void update(const JointInnovation& group);

 private:
  Eigen::Vector3d e_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d D_ = Eigen::Matrix3d::Zero();
};

}  // namespace slam
