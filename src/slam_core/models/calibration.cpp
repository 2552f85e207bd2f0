// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace slam {
namespace {

/// What is not estimated is right within this share of its prior's standard deviation.
constexpr double kTolerance = 0.05;

/// Names as they stand in `estimate`, and the rows that each is of.
struct Parameter {
  const char* name;
  std::vector<CalibrationParameter> rows;
  double CalibrationConfig::*sigma;
};

const std::array<Parameter, 7>& parameters() {
  using Config = CalibrationConfig;
  static const std::array<Parameter, 7> kParameters = {
      {{"wheel_scale", {kWheelScale}, &Config::sigma_wheel_scale},
       {"wheel_base", {kWheelBase}, &Config::sigma_wheel_base},
       {"wheel_drift", {kWheelDrift}, &Config::sigma_wheel_drift},
       {"sensor_yaw", {kSensorYaw}, &Config::sigma_sensor_yaw},
       {"sensor_offset", {kSensorX, kSensorY}, &Config::sigma_sensor_offset},
       {"range_scale", {kRangeScale}, &Config::sigma_range_scale},
       {"time_offset", {kTimeOffset}, &Config::sigma_time_offset}}};
  return kParameters;
}

/// A row as people read it.
struct Row {
  const char *name, *unit;
  bool is_scale;
};

const Row& textOf(CalibrationParameter row) {
  static const std::array<Row, kCalibrationRows> kRows = {{{"wheel_scale", "1", true},
                                                           {"wheel_base", "1", true},
                                                           {"wheel_drift", "rad/m", false},
                                                           {"sensor_yaw", "rad", false},
                                                           {"range_scale", "1", true},
                                                           {"sensor_x", "m", false},
                                                           {"sensor_y", "m", false},
                                                           {"time_offset", "s", false}}};
  return kRows[static_cast<std::size_t>(row)];
}

std::vector<std::string> parameterNames() {
  std::vector<std::string> names;
  for (const auto& parameter : parameters()) names.emplace_back(parameter.name);
  return names;
}

/// d exp(twist) / d omega, of (x, y, theta).
Eigen::Vector3d byTurn(const Eigen::Vector3d& twist) {
  constexpr double kSmall = 1e-4;  // [rad], where the series errs by 1e-9 of itself
  const double w = twist.z(), s = std::sin(w), c = std::cos(w);
  const bool is_small = std::abs(w) < kSmall;
  const double along = is_small ? -w / 3.0 : (w * c - s) / (w * w);
  const double across = is_small ? 0.5 - w * w / 8.0 : (w * s - (1.0 - c)) / (w * w);
  return {along * twist.x() - across * twist.y(), across * twist.x() + along * twist.y(), 1.0};
}

}  // namespace

void CalibrationConfig::describe(Fields& fields) {
  fields
      .add("estimate", &estimate,
           "what the back-end estimates of wheels and landmark sensor beside pose and map; nothing "
           "if empty")
      .oneOf(parameterNames());
  const auto sigma = [&](const std::string& name, double* value, const std::string& of_what,
                         const std::string& unit, double most) {
    fields
        .add("sigma_" + name, value,
             "standard deviation of " + of_what + " before the drive, where it is estimated")
        .unit(unit)
        .in({0.0, most, true, false})
        .ofRobot();
  };
  sigma("wheel_scale", &sigma_wheel_scale, "the wheels' scale, as a share", "1", 1.0);
  sigma("wheel_base", &sigma_wheel_base, "the distance of the wheels, as a share", "1", 1.0);
  sigma("wheel_drift", &sigma_wheel_drift, "a turn on the way that the wheels do not measure",
        "rad/m", 1.0);
  sigma("sensor_yaw", &sigma_sensor_yaw, "the sensor's heading on the robot", "rad", 1.0);
  sigma("range_scale", &sigma_range_scale, "the ranges' scale, as a share", "1", 1.0);
  sigma("sensor_offset", &sigma_sensor_offset, "each coordinate of the sensor on the robot", "m",
        10.0);
  sigma("time_offset", &sigma_time_offset, "the delay of the observations' stamps", "s", 1.0);
}

CalibrationEstimate CalibrationConfig::prior() const {
  CalibrationEstimate prior;
  for (const auto& parameter : parameters())
    for (const auto row : parameter.rows) {
      const bool is_right = row == kRangeScale || row == kTimeOffset;
      const double share = estimates(row) ? 1.0 : is_right ? 0.0 : kTolerance;
      const double sigma = share * this->*parameter.sigma;
      prior.covariance(row, row) = sigma * sigma;
    }
  return prior;
}

std::vector<CalibrationParameter> CalibrationConfig::estimatedRows() const {
  std::vector<CalibrationParameter> rows;
  for (const auto& parameter : parameters())
    if (std::find(estimate.begin(), estimate.end(), parameter.name) != estimate.end())
      rows.insert(rows.end(), parameter.rows.begin(), parameter.rows.end());
  return rows;
}

std::vector<std::string> CalibrationConfig::namesOfWheels() const {
  std::vector<std::string> names;
  for (const auto row : {kWheelScale, kWheelBase, kWheelDrift})
    if (estimates(row)) names.emplace_back(textOf(row).name);
  return names;
}

bool CalibrationConfig::estimates(CalibrationParameter row) const {
  const auto rows = estimatedRows();
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

bool CalibrationConfig::isTold(CalibrationParameter row, const CalibrationEstimate& known) const {
  constexpr double kTold = 0.3;
  return known.covariance(row, row) < kTold * kTold * prior().covariance(row, row);
}

bool CalibrationConfig::mixesScales(const CalibrationEstimate& known) const {
  constexpr double kLikeOne = 0.95;  // of the correlation
  const auto& P = known.covariance;
  const double both = std::sqrt(P(kWheelScale, kWheelScale) * P(kRangeScale, kRangeScale));
  return estimates(kWheelScale) && estimates(kRangeScale) &&
         std::abs(P(kWheelScale, kRangeScale)) > kLikeOne * both;
}

CalibrationVector CalibrationConfig::told(const CalibrationEstimate& known) const {
  CalibrationVector told = CalibrationVector::Zero();
  for (const auto row : estimatedRows()) told(row) = isTold(row, known) ? 1.0 : 0.0;
  if (mixesScales(known)) told(kWheelScale) = told(kRangeScale) = 0.0;
  return told;
}

std::vector<CalibratedParameter> CalibrationConfig::parametersOf(
    const CalibrationEstimate& known) const {
  std::vector<CalibratedParameter> result;
  const auto before = prior();
  for (const auto row : estimatedRows()) {
    const auto& text = textOf(row);
    const double value = known.parameters(row);
    const double scale = text.is_scale ? std::exp(value) : 1.0;
    result.push_back({text.name, text.unit, text.is_scale ? scale : value,
                      scale * std::sqrt(known.covariance(row, row)),
                      std::sqrt(before.covariance(row, row)), isTold(row, known)});
  }
  return result;
}

std::vector<std::string> CalibrationConfig::sentencesOn(const CalibrationEstimate& known) const {
  std::vector<std::string> sentences;
  for (const auto& parameter : parametersOf(known))
    sentences.push_back(fmt::format(
        "calibrated {}: {:.5g} with a standard deviation of {:.2g} [{}], {:.2g} before{}",
        parameter.name, parameter.value, parameter.sigma, parameter.unit, parameter.sigma_before,
        parameter.is_told ? "" : "; the drive does not tell it"));
  if (mixesScales(known))
    sentences.emplace_back(
        "the drive does not tell wheel_scale and range_scale apart: leave one of them out, or "
        "measure it");
  return sentences;
}

std::string CalibrationConfig::faultOf(const CalibrationEstimate& known) const {
  constexpr double kFarthest = 4.0;  // standard deviations
  const auto before = prior();
  for (const auto row : estimatedRows()) {
    const double sigmas = std::abs(known.parameters(row)) / std::sqrt(before.covariance(row, row));
    if (sigmas > kFarthest)
      return fmt::format(
          "the calibrated {} is {:.1f} standard deviations away from the robot file: check the "
          "robot file and what else may be wrong, or enlarge its sigma in the section calibration",
          textOf(row).name, sigmas);
  }
  return "";
}

Pose2 calibrated(const Pose2& increment, const CalibrationVector& parameters,
                 CalibrationJacobian<3>* J) {
  Eigen::Vector3d twist = increment.log();
  twist *= std::exp(parameters(kWheelScale));
  twist.z() *= std::exp(-parameters(kWheelBase));
  const double turned = twist.z();  // by the difference of the wheels
  twist.z() += parameters(kWheelDrift) * twist.x();
  const Pose2 result = Pose2::exp(twist);
  if (J != nullptr) {
    J->setZero(3, kCalibrationRows);
    J->col(kWheelScale) = result.twistJacobian() * twist;  // along the arc
    J->col(kWheelBase) = -turned * byTurn(twist);
    J->col(kWheelDrift) = twist.x() * byTurn(twist);
  }
  return result;
}

Motion calibrated(Motion motion, const CalibrationVector& parameters, CalibrationJacobian<3>* J) {
  motion.increment = calibrated(motion.increment, parameters, J);
  return motion;
}

LandmarkObservation calibrated(LandmarkObservation z, const CalibrationVector& parameters) {
  const double scale = std::exp(parameters(kRangeScale));
  z.range *= scale;
  z.covariance.row(0) *= scale;
  z.covariance.col(0) *= scale;
  z.extent = {scale * z.extent.begin, scale * z.extent.end};
  return z;
}

Pose2 calibrated(const Pose2& mount, const Eigen::Vector3d& velocity,
                 const CalibrationVector& parameters, CalibrationJacobian<3>* J) {
  const Pose2 moved = Pose2::exp(parameters(kTimeOffset) * velocity);
  const Pose2 sensor(mount.x() + parameters(kSensorX), mount.y() + parameters(kSensorY),
                     mount.theta() + parameters(kSensorYaw));
  Eigen::Matrix3d J_moved, J_sensor;
  const Pose2 result = moved.compose(sensor, &J_moved, &J_sensor);
  if (J != nullptr) {
    J->setZero(3, kCalibrationRows);
    J->col(kSensorX) = J_sensor.col(0);
    J->col(kSensorY) = J_sensor.col(1);
    J->col(kSensorYaw) = J_sensor.col(2);
    J->col(kTimeOffset) = J_moved * moved.twistJacobian() * velocity;
  }
  return result;
}

LandmarkObservationArray calibrated(LandmarkObservationArray array, const Eigen::Vector3d& velocity,
                                    const CalibrationVector& parameters) {
  array.sensor_pose = calibrated(array.sensor_pose, velocity, parameters);
  for (auto& z : array.observations) z = calibrated(std::move(z), parameters);
  return array;
}

}  // namespace slam
