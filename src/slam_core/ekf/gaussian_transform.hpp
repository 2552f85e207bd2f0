// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/ekf/dense_covariance.hpp"
#include "slam_core/ekf/linearization.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::ekf {

/// The robot after a motion, and what the motion makes of its error.
struct RobotTransition {
  Pose2 robot;
  PosePrediction error;
  Eigen::Matrix3d G;  ///< Jacobian of the pose by the increment
};

/// An observation of a landmark of the neighbourhood, and where its model is evaluated: at the
/// estimate, or at a candidate within an iterated update.
struct ObservedLandmark {
  const ObservationModel& model;  ///< of points
  Pose2 robot, sensor;
  LandmarkPoint landmark;
  const LandmarkObservation& z;
};

/// It passes a Gaussian through the models of motion and observation: it delivers the predicted
/// mean, F and Q, H and R, which are all that the algebra on the covariance takes in, so that this
/// algebra is the same for all. The linearisation says which error the covariance describes, and
/// thereby in which directions nothing can be observed.
class GaussianTransform {
 public:
  virtual ~GaussianTransform() = default;

  /// @param Q covariance of the increment's coordinates
  virtual RobotTransition predict(const Linearization& linearization, const PoseEstimate& robot,
                                  const Pose2& increment, const Eigen::Matrix3d& Q) const = 0;
  /// @param P of the errors about where the model is evaluated
  /// @param[in,out] innovation as the linearisation has it
  virtual void observe(const ObservedLandmark& observed, const ObservedCovariance& P,
                       Innovation& innovation) const = 0;
  /// The mean squared error of the pose's coordinates about the estimate, E[e e^T].
  virtual Eigen::Matrix3d meanSquaredError(const Linearization& linearization,
                                           const PoseEstimate& robot) const = 0;
};

/// It takes Jacobians, the first term of Taylor's series: this is the extended Kalman filter.
class TaylorTransform final : public GaussianTransform {
 public:
  RobotTransition predict(const Linearization& linearization, const PoseEstimate& robot,
                          const Pose2& increment, const Eigen::Matrix3d& Q) const override;
  void observe(const ObservedLandmark& /*observed*/, const ObservedCovariance& /*P*/,
               Innovation& /*innovation*/) const override {}
  Eigen::Matrix3d meanSquaredError(const Linearization& /*linearization*/,
                                   const PoseEstimate& robot) const override {
    return robot.covariance;
  }
};

const std::vector<std::string>& transformNames();

/// `name` is one of transformNames().
std::unique_ptr<GaussianTransform> makeTransform(const std::string& name);

}  // namespace slam::ekf
