// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include "slam_core/common/config_error.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"

// This file holds how the back-end calibrates wheels and landmark sensor.

namespace slam::graph_slam {

graph::OptimizerLimits GraphSlam::optimizerLimits(const GraphConfig& config) {
  graph::OptimizerLimits limits;
  limits.points_by_factor = !config.calibration.isOn();
  return limits;
}

void GraphSlam::checkCalibration(const GraphConfig& config) const {
  const auto& calibration = config.calibration;
  if (!calibration.isOn()) return;
  if (uses_grid_)
    throw ConfigError(
        "calibration.estimate: with map=grid nothing is calibrated, since scans tell the motion; "
        "use map=landmarks, or leave the list empty");
  if (config.mapIsFixed())
    throw ConfigError(
        "calibration.estimate: in a fixed map nothing is calibrated; use graph.mode=slam, or leave "
        "the list empty");
  if (calibration.estimates(kTimeOffset))
    throw ConfigError(
        "calibration.estimate: backend=graph does not calibrate time_offset; use backend=ekf, or "
        "leave it out of the list");
}

/// What is removed with a node has informed the parameters.
std::size_t GraphSlam::nodesPerPlace(const GraphConfig& config) {
  constexpr double kMoreWhileCalibrating = 2.5;
  const double factor = config.calibration.isOn() ? kMoreWhileCalibrating : 1.0;
  return static_cast<std::size_t>(std::ceil(factor * config.nodes_per_place));
}

std::optional<CalibrationEstimate> GraphSlam::calibration() const {
  const auto* parameters = graph_ ? parametersOf(graph_->path) : nullptr;
  if (parameters == nullptr) return std::nullopt;
  return parameters->estimate(graph_->path.graph());
}

LandmarkObservationArray GraphSlam::corrected(const LandmarkObservationArray& array) const {
  if (parametersOf(graph_->path) == nullptr) return array;
  return calibrated(array, Eigen::Vector3d::Zero(), calibrationOf(graph_->path));
}

/// Adds a measured motion to those that wait for the next step.
void GraphSlam::add(const Motion& measured) {
  Motion motion = measured;
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  if (parametersOf(graph_->path) != nullptr) {
    const auto parameters = calibrationOf(graph_->path);
    CalibrationJacobian<3> J_parameters;
    motion = calibrated(measured, parameters, &J_parameters);
    J = J_parameters.leftCols<3>();
    const Eigen::DiagonalMatrix<double, 3> growth(
        graph::WheelMotion().growth(parameters.head<3>()));
    motion.covariance = growth * motion.covariance * growth;
  }
  Eigen::Matrix3d J_before, J_u;
  const Pose2 before = motion_ ? motion_->increment : Pose2();
  before.compose(motion.increment, &J_before, &J_u);
  J_wheels_ = motion_ ? Eigen::Matrix3d(J_before * J_wheels_ + J_u * J) : J;
  motion_ = motion_ ? joined(*motion_, motion) : motion;
}

}  // namespace slam::graph_slam
