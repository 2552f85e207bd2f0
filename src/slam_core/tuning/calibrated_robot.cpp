// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/calibrated_robot.hpp"

#include <cmath>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/models/landmark_sensor.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/tuning/robot_file_text.hpp"
#include "slam_core/wheel_odometry/wheel_odometry.hpp"

namespace slam::tuning {
namespace {

/// A value of the robot file: before times the exponential of these parameters, or plus them.
struct RobotValue {
  std::string section, key;
  double before;
  CalibrationVector weights;
  bool is_scale;
};

CalibrationVector weightsOf(CalibrationParameter row) {
  return CalibrationVector::Unit(kCalibrationRows, row);
}

std::vector<RobotValue> valuesOf(Settings& settings) {
  const auto sensor = settings.read<LandmarkSensorConfig>();
  const std::string of_sensor = LandmarkSensorConfig::kSection;
  std::vector<RobotValue> values = {
      {of_sensor, "range_scale", sensor.range_scale, weightsOf(kRangeScale), true},
      {of_sensor, "mount_x", sensor.mount_x, weightsOf(kSensorX), false},
      {of_sensor, "mount_y", sensor.mount_y, weightsOf(kSensorY), false},
      {of_sensor, "mount_yaw", sensor.mount_yaw, weightsOf(kSensorYaw), false},
      {of_sensor, "time_offset", sensor.time_offset, weightsOf(kTimeOffset), false}};
  if (settings.read<ProductConfig>().odometry != "wheel") return values;
  const auto wheels = settings.read<wheel_odometry::WheelOdometryConfig>();
  const std::string of_wheels = wheel_odometry::WheelOdometryConfig::kSection;
  const CalibrationVector turn = weightsOf(kWheelScale) - weightsOf(kWheelBase);
  values.push_back(
      {of_wheels, "translation_scale", wheels.translation_scale, weightsOf(kWheelScale), true});
  values.push_back({of_wheels, "rotation_scale", wheels.rotation_scale, turn, true});
  values.push_back({of_wheels, "drift", wheels.drift, weightsOf(kWheelDrift), false});
  return values;
}

bool isEstimated(const RobotValue& value, const CalibrationConfig& config) {
  for (Eigen::Index row = 0; row < kCalibrationRows; ++row)
    if (value.weights(row) != 0.0 && config.estimates(static_cast<CalibrationParameter>(row)))
      return true;
  return false;
}

TunedParameter tuned(const RobotValue& value, const CalibrationEstimate& before,
                     const CalibrationEstimate& now) {
  constexpr double kKnown = 0.3;  // as CalibratedParameter
  const auto& w = value.weights;
  const double change = w.dot(now.parameters), sigma = std::sqrt(w.dot(now.covariance * w));
  TunedParameter parameter;
  parameter.section = value.section;
  parameter.key = value.key;
  parameter.before = value.before;
  parameter.value = value.is_scale ? value.before * std::exp(change) : value.before + change;
  parameter.digits = 6;
  parameter.sigma = value.is_scale ? parameter.value * sigma : sigma;
  if (sigma > kKnown * std::sqrt(w.dot(before.covariance * w)))
    parameter.why_unseen = "the drive does not tell it";
  return parameter;
}

}  // namespace

std::vector<TunedParameter> calibratedParameters(const Calibrator& calibrator, Settings settings) {
  const auto now = calibrator.calibration();
  if (!now) return {};
  const auto& config = calibrator.calibrationConfig();
  std::vector<TunedParameter> parameters;
  for (const auto& value : valuesOf(settings))
    if (isEstimated(value, config)) parameters.push_back(tuned(value, config.prior(), *now));
  return parameters;
}

std::optional<std::string> calibratedRobot(const Calibrator& calibrator, const Settings& settings,
                                           const std::string& robot_file) {
  const auto now = calibrator.calibration();
  if (!now) return std::nullopt;
  const auto told = calibrator.calibrationConfig().sentencesOn(*now);
  return withTunedValues(robot_file, calibratedParameters(calibrator, settings),
                         calibrationRemark(told));
}

void saveCalibration(const Capabilities& backend, const Settings& settings,
                     const std::string& robot_file, const std::string& folder) {
  const auto* calibrator = backend.find<Calibrator>();
  if (calibrator == nullptr) return;
  if (const auto text = calibratedRobot(*calibrator, settings, robot_file))
    writeFileAtomically(folder + "/robot.yaml", *text);
}

}  // namespace slam::tuning
