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

/// A value of the robot file: before * exp(scale . c) + sum . c, with c the parameters.
struct RobotValue {
  std::string section, key;
  double before;
  CalibrationVector scale, sum;
};

CalibrationVector only(CalibrationParameter row) {
  return CalibrationVector::Unit(kCalibrationRows, row);
}

std::vector<RobotValue> valuesOf(Settings& settings) {
  const CalibrationVector none = CalibrationVector::Zero();
  const auto sensor = settings.read<LandmarkSensorConfig>();
  const std::string of_sensor = LandmarkSensorConfig::kSection;
  std::vector<RobotValue> values = {
      {of_sensor, "range_scale", sensor.range_scale, only(kRangeScale), none},
      {of_sensor, "mount_x", sensor.mount_x, none, only(kSensorX)},
      {of_sensor, "mount_y", sensor.mount_y, none, only(kSensorY)},
      {of_sensor, "mount_yaw", sensor.mount_yaw, none, only(kSensorYaw)},
      {of_sensor, "time_offset", sensor.time_offset, none, only(kTimeOffset)}};
  if (settings.read<ProductConfig>().odometry != "wheel") return values;
  const auto wheels = settings.read<wheel_odometry::WheelOdometryConfig>();
  const std::string of_wheels = wheel_odometry::WheelOdometryConfig::kSection;
  const CalibrationVector turn = only(kWheelScale) - only(kWheelBase);
  values.push_back(
      {of_wheels, "translation_scale", wheels.translation_scale, only(kWheelScale), none});
  values.push_back({of_wheels, "rotation_scale", wheels.rotation_scale, turn, none});
  values.push_back({of_wheels, "drift", wheels.drift, -only(kWheelBase), only(kWheelDrift)});
  return values;
}

TunedParameter tuned(const RobotValue& value, const CalibrationEstimate& now,
                     const CalibrationVector& told) {
  const CalibrationVector scale = value.scale.cwiseProduct(told);
  const CalibrationVector sum = value.sum.cwiseProduct(told);
  const double scaled = value.before * std::exp(scale.dot(now.parameters));
  const CalibrationVector J = scaled * scale + sum;
  TunedParameter parameter;
  parameter.section = value.section;
  parameter.key = value.key;
  parameter.before = value.before;
  parameter.value = scaled + sum.dot(now.parameters);
  parameter.digits = 6;
  parameter.sigma = std::sqrt(J.dot(now.covariance * J));
  if (J.isZero(0.0)) parameter.why_unseen = "the drive does not tell it";
  return parameter;
}

}  // namespace

std::vector<TunedParameter> calibratedParameters(const Calibrator& calibrator, Settings settings) {
  const auto now = calibrator.calibration();
  if (!now) return {};
  const auto told = calibrator.calibrationConfig().told(*now);
  std::vector<TunedParameter> parameters;
  for (const auto& value : valuesOf(settings)) parameters.push_back(tuned(value, *now, told));
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

std::string saveCalibration(const Capabilities& backend, const Settings& settings,
                            const std::function<std::string()>& robotFile,
                            const std::string& folder) {
  const auto* calibrator = backend.find<Calibrator>();
  if (calibrator == nullptr || !calibrator->calibration()) return "";
  try {
    if (const auto text = calibratedRobot(*calibrator, settings, robotFile()))
      writeFileAtomically(folder + "/robot.yaml", *text);
    return "";
  } catch (const std::exception& error) {
    return std::string("no robot file with what was calibrated is written: ") + error.what();
  }
}

}  // namespace slam::tuning
