// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu/imu_reading.hpp"

#include <fmt/format.h>

#include <cmath>

#include "slam_core/geometry/mount.hpp"

namespace slam {
namespace {

/// Ten times the range of the fastest MEMS gyros in degrees [rad/s].
constexpr double kFastestRate = 20000.0;
/// Of one reading, above which a covariance says nothing [rad^2/s^2].
constexpr double kLargestRateVariance = 100.0;

bool isGiven(const Eigen::Matrix3d& covariance) {
  return covariance.allFinite() && covariance.diagonal().minCoeff() >= 0.0 &&
         covariance.diagonal().maxCoeff() > 0.0 &&
         covariance.cwiseAbs().maxCoeff() <= kLargestRateVariance;
}

}  // namespace

std::string faultOf(const ImuReading& reading) {
  if (!reading.angular_velocity.allFinite()) return "its angular velocity is not a number";
  const double fastest = reading.angular_velocity.cwiseAbs().maxCoeff();
  if (fastest > kFastestRate)
    return fmt::format("its angular velocity is {:g} rad/s, which no gyro measures", fastest);
  return "";
}

std::string faultOf(const ImuMount& mount) { return faultOfMount(mount.T_base_imu); }

bool saysNoGyro(const ImuReading& reading) {
  return reading.covariance(0, 0) == -1.0 && reading.angular_velocity.isZero(0.0);
}

ImuReading fromDegrees(const ImuReading& reading) {
  constexpr double kRadians = M_PI / 180.0;
  auto converted = reading;
  converted.angular_velocity *= kRadians;
  if (isGiven(reading.covariance)) converted.covariance *= kRadians * kRadians;
  return converted;
}

ImuSample toSample(const ImuReading& reading, const ImuMount& mount) {
  const Eigen::Matrix3d R = mount.T_base_imu.linear();
  ImuSample sample;
  sample.stamp = reading.stamp;
  sample.angular_velocity = R * reading.angular_velocity;
  if (isGiven(reading.covariance)) sample.covariance = R * reading.covariance * R.transpose();
  return sample;
}

}  // namespace slam
