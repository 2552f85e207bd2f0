// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// The derivatives of the predicted pose and of its covariance with respect to the odometry's
/// noise: e = dx/dtheta and D = dP/dtheta, where theta is the relative excess of the true variance,
/// for the pose (x, y, heading) relative to the landmarks. A filter that trusts its odometry too
/// much lags behind: an error of one step shows in the following ones, so that e is far more
/// sensitive to a slightly wrong odometry sigma than a single step is (Gupta and Mehra 1974, the
/// sensitivity equations of the Kalman filter, here for the pose alone).
class OdometrySensitivity {
 public:
  /// e [m, m, rad] and D [m^2, m rad, rad^2].
  const Eigen::Vector3d& mean() const { return e_; }
  const Eigen::Matrix3d& covariance() const { return D_; }

  void predict(const PosePrediction& prediction);
  /// @param group of which H is known
  void update(const JointInnovation& group);

  template <class Archive>
  void persist(Archive& archive) {
    archive(e_, D_);
  }

 private:
  Eigen::Vector3d e_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d D_ = Eigen::Matrix3d::Zero();
};

}  // namespace slam
