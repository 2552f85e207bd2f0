// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/scan_matching/registration.hpp"

namespace slam::scan_matching {

/// The errors of the wheels' motion. They are larger than its covariance says: wheels slip, and a
/// lurch of a second is not Gaussian. Their size is learnt from scans. It begins with large
/// standard deviations: a fifth of the translation and of the turn, a tenth of each for the other
/// (per metre and per radian), and 2 cm and 0.02 rad. These shares have the roles of alpha_1 to
/// alpha_4 of the odometry motion model (Thrun, Burgard, Fox 2005, sec. 5.4), but here the standard
/// deviations are added instead of the variances.
class SlipEstimate {
 public:
  /// In the coordinates of the reported increment.
  Eigen::Matrix3d covarianceOf(const Pose2& increment) const;
  /// @param error of the increment, as a scan has found it, in the increment's coordinates
  /// @param shares of the error that the scan determines, in each coordinate, 0 to 1
  void learn(const Pose2& increment, const Pose2& error, const Eigen::Vector3d& shares);

  template <class Archive>
  void persist(Archive& archive) {
    archive(position_, heading_);
  }

 private:
  double position_ = 1.0, heading_ = 1.0;  ///< variances, relative to the initial ones
};

/// The prior of a scan's pose, from the pose of the scan before and the motion in between.
/// @param covariance of `before`, in (x, y, theta)
/// @param noise of the increment, in its coordinates
PosePrior priorAfter(const Pose2& before, const Eigen::Matrix3d& covariance, const Pose2& increment,
                     const Eigen::Matrix3d& noise);

}  // namespace slam::scan_matching
