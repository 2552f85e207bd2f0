// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/ekf/gaussian_transform.hpp"

namespace slam::ekf {

/// It takes sigma points (Julier, Uhlmann 2004) and statistical linear regression (Lefebvre,
/// Bruyninckx, De Schutter 2002) over what a step involves: the unscented Kalman filter of Huang,
/// Mourikis, Roumeliotis 2013, whose cost in the size of the map is that of the extended one. What
/// the regression leaves unexplained is added to the noise. The error of a sigma point is that of
/// the linearisation: it moves the estimate as a correction would.
///
/// Regression alone would take some of the error of a direction that cannot be observed for
/// something that was observed. So it is restricted to those predictors that are zero in these
/// directions:
/// - the robot's motion carries the errors of robot and map along together: F = (I, J (p' - p); 0
///   1), with the predicted mean p';
/// - an observation depends on robot and landmark through delta = H_m^-1 H e alone, the error of
///   where the landmark lies from the robot, H the linearisation's Jacobian. So the points are
///   drawn over these two numbers, and the Jacobian becomes A H_m^-1 H, with A the regression on
///   delta.
/// Where the heading may be anything, motion is treated as by the extended filter.
class UnscentedTransform final : public GaussianTransform {
 public:
  RobotTransition predict(const Linearization& linearization, const PoseEstimate& robot,
                          const Pose2& increment, const Eigen::Matrix3d& Q) const override;
  void observe(const ObservedLandmark& observed, const ObservedCovariance& P,
               Innovation& innovation) const override;
  Eigen::Matrix3d meanSquaredError(const Linearization& linearization,
                                   const PoseEstimate& robot) const override;
};

}  // namespace slam::ekf
