// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/calibrated_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::tuning {
namespace {

/// A back-end that knows this of wheels and sensor.
class Known final : public Calibrator {
 public:
  explicit Known(std::vector<std::string> estimate) {
    config_.estimate = std::move(estimate);
    known_ = config_.prior();
  }
  void learn(CalibrationParameter parameter, double value, double sigma) {
    known_.parameters(parameter) = value;
    known_.covariance(parameter, parameter) = sigma * sigma;
  }
  void correlate(CalibrationParameter a, CalibrationParameter b, double covariance) {
    known_.covariance(a, b) = known_.covariance(b, a) = covariance;
  }
  std::optional<CalibrationEstimate> calibration() const override {
    if (config_.isOn()) return known_;
    return std::nullopt;
  }
  const CalibrationConfig& calibrationConfig() const override { return config_; }
  LandmarkObservationArray corrected(const LandmarkObservationArray& array) const override {
    return array;
  }

 private:
  CalibrationConfig config_;
  CalibrationEstimate known_;
};

const char* const kRobot =
    "version: 1\nrobot: a\n\nwheel_odometry:\n  translation_scale: 0.9  # [1]\n"
    "  rotation_scale: 1.1     # [1]\n";

Settings settings(const std::string& robot = kRobot) {
  return {
      {"product", YAML::Load("{version: 1, odometry: wheel}")}, {"robot", YAML::Load(robot)}, {}};
}

TEST(CalibratedRobot, MultipliesScalesAndAddsOffsets) {
  Known known({"wheel_scale", "wheel_base", "wheel_drift", "sensor_yaw", "sensor_offset"});
  known.learn(kWheelScale, std::log(1.2), 0.001);
  known.learn(kWheelBase, std::log(1.5), 0.001);
  known.learn(kWheelDrift, 0.02, 0.001);
  known.learn(kSensorYaw, -0.1, 0.001);
  known.learn(kSensorX, 0.05, 0.001);
  const auto robot = YAML::Load(*calibratedRobot(known, settings(), kRobot));
  EXPECT_NEAR(robot["wheel_odometry"]["translation_scale"].as<double>(), 0.9 * 1.2, 1e-5);
  EXPECT_NEAR(robot["wheel_odometry"]["rotation_scale"].as<double>(), 1.1 * 1.2 / 1.5, 1e-5);
  EXPECT_NEAR(robot["wheel_odometry"]["drift"].as<double>(), 0.02, 1e-9);
  EXPECT_NEAR(robot["landmark_sensor"]["mount_yaw"].as<double>(), -0.1, 1e-9);
  EXPECT_NEAR(robot["landmark_sensor"]["mount_x"].as<double>(), 0.05, 1e-9);
  EXPECT_FALSE(robot["landmark_sensor"]["mount_y"]) << "the drive did not tell it";
  EXPECT_FALSE(robot["landmark_sensor"]["range_scale"]) << "it was not estimated";
}

TEST(CalibratedRobot, SaysWhatTheDriveToldAndReplacesThatTheNextTime) {
  Known known({"wheel_scale", "sensor_yaw"});
  known.learn(kWheelScale, 0.1, 0.001);
  const auto once = *calibratedRobot(known, settings(), kRobot);
  EXPECT_NE(once.find("# calibrated wheel_scale: 1.1052 with a standard deviation of 0.0011 [1]"),
            std::string::npos)
      << once;
  EXPECT_NE(once.find("sensor_yaw: 0 with a standard deviation of 0.1 [rad], 0.1 before; the drive "
                      "does not tell it"),
            std::string::npos)
      << once;
  known.learn(kWheelScale, 0.0, 0.001);
  const auto twice = *calibratedRobot(known, settings(once), once);
  EXPECT_EQ(twice.find("1.1052"), std::string::npos) << twice;
  EXPECT_NE(twice.find("calibrated wheel_scale: 1 with"), std::string::npos) << twice;
}

/// Ranges are correlated with wheels that are not estimated: these tell their scale.
TEST(CalibratedRobot, HasTheScaleOfTheRangesUnlessBothScalesAreEstimated) {
  for (const bool are_both : {false, true}) {
    Known known(are_both ? std::vector<std::string>{"wheel_scale", "range_scale"}
                         : std::vector<std::string>{"range_scale"});
    known.learn(kWheelScale, 0.0, 0.01);
    known.learn(kRangeScale, 0.1, 0.01);
    known.correlate(kWheelScale, kRangeScale, 0.99e-4);
    const auto text = *calibratedRobot(known, settings(), kRobot);
    EXPECT_EQ(text.find("  range_scale: 1.1") != std::string::npos, !are_both) << text;
  }
}

TEST(CalibratedRobot, IsNotWrittenWhereNothingIsEstimated) {
  EXPECT_FALSE(calibratedRobot(Known({}), settings(), kRobot));
}

}  // namespace
}  // namespace slam::tuning
