// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slam {
namespace {

CalibrationVector someParameters() {
  CalibrationVector c;
  c << 0.2, -0.1, 0.05, 0.3, 0.1, 0.2, -0.15, 0.04;
  return c;
}

/// The Jacobian of a pose by central differences.
Eigen::Matrix<double, 3, kCalibrationRows> numericJacobian(
    const std::function<Pose2(const CalibrationVector&)>& f) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 3, kCalibrationRows> J;
  for (Eigen::Index i = 0; i < kCalibrationRows; ++i) {
    const CalibrationVector step = kStep * CalibrationVector::Unit(i);
    const auto c = someParameters();
    J.col(i) = (f(c + step).vector() - f(c - step).vector()) / (2.0 * kStep);
  }
  return J;
}

TEST(Calibration, ZeroesLeaveAllAsItIs) {
  const CalibrationVector none = CalibrationVector::Zero();
  const Pose2 increment(0.3, 0.02, 0.1), mount(0.1, 0.05, 0.3);
  EXPECT_LT(increment.between(calibrated(increment, none)).vector().norm(), 1e-15);
  EXPECT_LT(mount.between(calibrated(mount, {1.0, 0.0, 0.5}, none)).vector().norm(), 1e-15);
}

TEST(Calibration, TheJacobianOfAMotionIsItsDerivative) {
  for (const auto& increment : {Pose2(0.3, 0.02, 0.4), Pose2(0.3, 0.0, 0.0), Pose2(0, 0, 0.2)}) {
    CalibrationJacobian<3> J;
    calibrated(increment, someParameters(), &J);
    const auto numeric =
        numericJacobian([&](const CalibrationVector& c) { return calibrated(increment, c); });
    EXPECT_LT((J - numeric).norm(), 1e-8) << increment.theta();
  }
}

TEST(Calibration, TheJacobianOfASensorIsItsDerivative) {
  const Pose2 mount(0.2, -0.1, 0.5);
  const Eigen::Vector3d velocity(0.8, 0.1, 0.6);
  CalibrationJacobian<3> J;
  calibrated(mount, velocity, someParameters(), &J);
  const auto numeric =
      numericJacobian([&](const CalibrationVector& c) { return calibrated(mount, velocity, c); });
  EXPECT_LT((J - numeric).norm(), 1e-8);
}

/// Two wheels as a driver measures them: each has its own radius, and they are apart by something
/// else than the driver believes.
TEST(Calibration, ItsWheelParametersDescribeTwoWheels) {
  const double left = 0.97, right = 1.02, believed = 0.5, base = 0.53;  // true over measured, [m]
  const double measured_left = 0.2, measured_right = 0.3;               // [m]
  const Pose2 measured = Pose2::exp(
      {0.5 * (measured_left + measured_right), 0.0, (measured_right - measured_left) / believed});
  const Pose2 truth = Pose2::exp({0.5 * (left * measured_left + right * measured_right), 0.0,
                                  (right * measured_right - left * measured_left) / base});
  // v = m V + (right - left) / 4 B W, where m is the mean of the scales, V and W are measured; the
  // second part is a change of the way by a turn, of second order, which the parameters leave out.
  CalibrationVector c = CalibrationVector::Zero();
  const double mean = 0.5 * (left + right);
  c(kWheelScale) = std::log(mean);
  c(kWheelBase) = std::log(base / believed);
  c(kWheelDrift) = (right - left) / (mean * base);
  const auto error = truth.between(calibrated(measured, c)).vector();
  EXPECT_LT(error.head<2>().norm(), 0.25 * (right - left) * believed * 0.2 + 1e-4);
  EXPECT_NEAR(error.z(), 0.0, 1e-12);
}

TEST(Calibration, ScalesARangeWithItsNoise) {
  LandmarkObservation z;
  z.range = 2.0;
  z.covariance << 0.04, 0.001, 0.001, 0.01;
  CalibrationVector c = CalibrationVector::Zero();
  c(kRangeScale) = std::log(1.5);
  const auto scaled = calibrated(z, c);
  EXPECT_NEAR(scaled.range, 3.0, 1e-12);
  EXPECT_NEAR(scaled.covariance(0, 0), 0.09, 1e-12);
  EXPECT_NEAR(scaled.covariance(0, 1), 0.0015, 1e-12);
  EXPECT_NEAR(scaled.covariance(1, 1), 0.01, 1e-12);
}

TEST(CalibrationConfig, WhatIsNotEstimatedIsNearlyKnown) {
  CalibrationConfig config;
  config.estimate = {"wheel_scale", "sensor_offset"};
  const auto prior = config.prior();
  EXPECT_NEAR(std::sqrt(prior.covariance(kWheelScale, kWheelScale)), 0.2, 1e-12);
  EXPECT_NEAR(std::sqrt(prior.covariance(kSensorY, kSensorY)), 0.1, 1e-12);
  EXPECT_NEAR(std::sqrt(prior.covariance(kSensorYaw, kSensorYaw)), 0.005, 1e-12);
  EXPECT_EQ(prior.covariance(kRangeScale, kRangeScale), 0.0) << "ranges are the unit of length";
  EXPECT_EQ(prior.covariance(kTimeOffset, kTimeOffset), 0.0) << "noise would pass for a delay";
}

TEST(CalibrationConfig, SaysWhatADriveDoesNotTell) {
  CalibrationConfig config;
  config.estimate = {"wheel_scale", "range_scale"};
  auto known = config.prior();
  known.parameters(kWheelScale) = std::log(1.1);
  auto sentences = config.sentencesOn(known);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_NE(sentences[0].find("wheel_scale: 1.1"), std::string::npos) << sentences[0];
  EXPECT_NE(sentences[0].find("the drive does not tell it"), std::string::npos) << sentences[0];

  known.covariance(kWheelScale, kWheelScale) = known.covariance(kRangeScale, kRangeScale) = 0.005;
  known.covariance(kWheelScale, kRangeScale) = known.covariance(kRangeScale, kWheelScale) = 0.0049;
  sentences = config.sentencesOn(known);
  EXPECT_NE(sentences.back().find("does not tell wheel_scale and range_scale apart"),
            std::string::npos)
      << sentences.back();
}

TEST(CalibrationConfig, TellsOfAParameterThatRunsAway) {
  CalibrationConfig config;
  config.estimate = {"sensor_yaw"};
  auto known = config.prior();
  known.parameters(kSensorYaw) = -0.39;
  EXPECT_EQ(config.faultOf(known), "");
  known.parameters(kSensorYaw) = -0.41;
  EXPECT_NE(config.faultOf(known).find("sensor_yaw is 4.1 standard deviations away"),
            std::string::npos)
      << config.faultOf(known);
}

}  // namespace
}  // namespace slam
