// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/calibration.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::test {

/// A robot that goes round among point landmarks, now faster and now slower, and whose wheels and
/// sensor are off by parameters that its messages know nothing of. But for those its motion and
/// what it sees have the noise they claim. It starts at the origin.
class MiscalibratedRobot {
 public:
  MiscalibratedRobot(std::uint64_t seed, const CalibrationVector& off)
      : off_(off), random_(seed, 7) {
    for (int i = 0; i < 30; ++i)
      landmarks_.emplace_back(16.0 * random_.uniform() - 8.0, 16.0 * random_.uniform() - 4.0);
  }

  const std::vector<Eigen::Vector2d>& landmarks() const { return landmarks_; }

  SimulatedStep next(bool moves = true) {
    const Eigen::Vector3d twist = moves ? steered() : Eigen::Vector3d::Zero();
    SimulatedStep step;
    step.motion.sequence = count_;
    step.motion.start = stamp(count_);
    step.motion.end = stamp(++count_);
    step.motion.increment = Pose2::exp(measured(twist));
    step.motion.covariance = kMotionSigma.cwiseAbs2().asDiagonal();
    truth_ = truth_ * Pose2::fromVector(Pose2::exp(twist).vector() + noise(kMotionSigma));
    step.observations = look(twist / 0.2);
    step.truth = truth_;
    return step;
  }

 private:
  inline static const Eigen::Vector3d kMotionSigma{0.004, 0.002, 0.003};
  inline static const Eigen::Vector2d kSightSigma{0.03, 0.01};

  static Stamp stamp(std::uint64_t count) {
    return stampFromNanoseconds(1000000000000) + count * std::chrono::milliseconds(200);
  }
  template <int N>
  Eigen::Matrix<double, N, 1> noise(const Eigen::Matrix<double, N, 1>& sigma) {
    Eigen::Matrix<double, N, 1> white;
    for (auto& element : white) element = random_.gaussian();
    return sigma.cwiseProduct(white);
  }

  /// Along a wavy ring around (0, 4), now faster and now slower.
  Eigen::Vector3d steered() const {
    const Eigen::Vector2d centre(0.0, 4.0), from_centre = truth_.position() - centre;
    const double ahead = std::atan2(from_centre.y(), from_centre.x()) + 0.25;
    const double radius = 4.0 + 1.5 * std::sin(5.0 * ahead);
    const auto goal = truth_.inverse().transform(
        centre + radius * Eigen::Vector2d(std::cos(ahead), std::sin(ahead)));
    const double turn = 0.3 * std::atan2(goal.y(), goal.x());
    return {0.2 + 0.1 * std::sin(static_cast<double>(count_) / 7.0), 0.0, turn};
  }

  /// @return the twist as the wheels measure it
  Eigen::Vector3d measured(const Eigen::Vector3d& twist) const {
    const double scale = std::exp(off_(kWheelScale));
    const double turn = twist.z() - off_(kWheelDrift) * twist.x();
    return {twist.x() / scale, twist.y() / scale, turn * std::exp(off_(kWheelBase)) / scale};
  }

  LandmarkObservationArray look(const Eigen::Vector3d& velocity) {
    LandmarkObservationArray array;
    array.sequence = count_;
    array.stamp = stamp(count_);
    array.sensor_frame = "camera";
    array.sensor_pose = Pose2(0.2, -0.05, 0.1);
    const Pose2 sensor = truth_ * calibrated(array.sensor_pose, velocity, off_);
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      const auto m = sensor.inverse().transform(landmarks_[i]);
      if (m.norm() > 6.0 || m.norm() < 0.5) continue;
      const auto error = noise(kSightSigma);
      LandmarkObservation z;
      z.id = static_cast<LandmarkId>(i);
      z.range = (m.norm() + error.x()) * std::exp(-off_(kRangeScale));
      z.bearing = std::remainder(std::atan2(m.y(), m.x()) + error.y(), 2.0 * M_PI);
      z.covariance = kSightSigma.cwiseAbs2().asDiagonal();
      array.observations.push_back(z);
    }
    return array;
  }

  CalibrationVector off_;
  RandomStream random_;
  std::vector<Eigen::Vector2d> landmarks_;
  Pose2 truth_;
  std::uint64_t count_ = 0;
};

}  // namespace slam::test
