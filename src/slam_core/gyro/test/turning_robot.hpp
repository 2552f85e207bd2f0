// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/imu_sample.hpp"
#include "slam_core/models/motion_model.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam::gyro::test {

/// Part of a drive.
struct Leg {
  double seconds, speed, turn_rate;  ///< [s], [m/s], [rad/s]
};

/// The errors of a robot's wheels: systematic ones of their heading, and random ones.
struct WheelErrors {
  double turn_share = 0.0;  ///< turns are measured too large by this share
  double drift = 0.0;       ///< turn that is measured on a metre of a straight way [rad/m]
  OdometryNoise noise;      ///< of LinearMotionModel
};

struct GyroErrors {
  double bias = 0.0;   ///< at the start [rad/s]
  double walk = 0.0;   ///< of the bias [rad/s/sqrt(s)]
  double noise = 0.0;  ///< [rad/sqrt(s)]
  double scale = 0.0;  ///< turns are measured too large by this share
};

/// A robot that follows legs, with what its wheels and its gyro measure.
class TurningRobot {
 public:
  struct Rates {
    double wheels = 40.0, gyro = 100.0;  ///< [Hz], of 1000
  };
  struct Truth {
    Stamp stamp;
    Pose2 pose;
  };

  TurningRobot(std::uint64_t seed, const WheelErrors& wheels, const GyroErrors& gyro)
      : TurningRobot(seed, wheels, gyro, Rates()) {}
  TurningRobot(std::uint64_t seed, const WheelErrors& wheels, const GyroErrors& gyro, Rates rates)
      : random_(seed, 0),
        wheel_errors_(wheels),
        gyro_errors_(gyro),
        rates_(rates),
        bias_(gyro.bias) {}

  void drive(const std::vector<Leg>& legs) {
    for (const auto& leg : legs)
      for (int step = 0; step < std::lround(leg.seconds / kStep); ++step) advance(leg);
  }

  const std::vector<OdometrySample>& wheels() const { return wheels_; }
  const std::vector<ImuSample>& gyro() const { return gyro_; }
  const std::vector<Truth>& truth() const { return truth_; }  ///< one for each of wheels()
  double bias() const { return bias_; }

 private:
  static constexpr double kStep = 0.001;     // [s]
  static constexpr double kResponse = 0.15;  // of the motors [s]

  void advance(const Leg& leg) {
    if (steps_ % std::lround(1.0 / (kStep * rates_.wheels)) == 0) readWheels();
    if (steps_ % std::lround(1.0 / (kStep * rates_.gyro)) == 3) readGyro();
    const double share = kStep / kResponse;
    velocity_ += share * (Eigen::Vector3d(leg.speed, 0.0, leg.turn_rate) - velocity_);
    if (leg.speed == 0.0 && leg.turn_rate == 0.0 && velocity_.norm() < 0.01) velocity_.setZero();
    const Eigen::Vector3d twist = kStep * velocity_;
    pose_ = pose_ * Pose2::exp(twist);
    measured_ = measured_ * Pose2::exp(measure(twist));
    bias_ += gyro_errors_.walk * std::sqrt(kStep) * random_.gaussian();
    ++steps_;
  }

  Eigen::Vector3d measure(Eigen::Vector3d twist) {
    const auto& noise = wheel_errors_.noise;
    const double d = std::abs(twist.x()), r = std::abs(twist.z());
    if (d == 0.0 && r == 0.0) return twist;
    const double way = std::sqrt(noise.alpha1 * d + noise.alpha2 * r) * random_.gaussian();
    const double turn = std::sqrt(noise.alpha3 * d + noise.alpha4 * r) * random_.gaussian();
    const double across = noise.omnidirectional
                              ? std::sqrt(noise.alpha1 * d + noise.alpha2 * r) * random_.gaussian()
                              : 0.0;
    return {twist.x() + way, across,
            (1.0 + wheel_errors_.turn_share) * twist.z() + wheel_errors_.drift * twist.x() + turn};
  }

  Stamp now() const { return Stamp(std::chrono::seconds(100) + std::chrono::milliseconds(steps_)); }

  void readWheels() {
    OdometrySample sample;
    sample.stamp = now();
    sample.pose = measured_;
    sample.odometry_frame = "odom";
    sample.base_frame = "base_link";
    wheels_.push_back(sample);
    truth_.push_back({now(), pose_});
  }

  void readGyro() {
    ImuSample sample;
    sample.stamp = now();
    const double noise = gyro_errors_.noise * std::sqrt(rates_.gyro) * random_.gaussian();
    sample.angular_velocity.z() = (1.0 + gyro_errors_.scale) * velocity_.z() + bias_ + noise;
    gyro_.push_back(sample);
  }

  RandomStream random_;
  WheelErrors wheel_errors_;
  GyroErrors gyro_errors_;
  Rates rates_;
  double bias_;
  long steps_ = 0;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< of the body [m/s, m/s, rad/s]
  Pose2 pose_, measured_;                               ///< from the start
  std::vector<OdometrySample> wheels_;
  std::vector<ImuSample> gyro_;
  std::vector<Truth> truth_;
};

/// A drive of all sorts: it stands, goes straight, turns both ways.
inline std::vector<Leg> someDrive(double rest = 2.0) {
  return {{rest, 0.0, 0.0}, {4.0, 0.5, 0.0},  {3.0, 0.3, 0.5}, {4.0, 0.5, 0.1}, {3.0, 0.3, -0.6},
          {2.0, 0.0, 0.0},  {4.0, 0.6, -0.1}, {3.0, 0.2, 0.8}, {5.0, 0.5, 0.0}, {3.0, 0.4, -0.4}};
}

}  // namespace slam::gyro::test
