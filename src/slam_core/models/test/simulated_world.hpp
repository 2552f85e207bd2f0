// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <map>
#include <utility>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/covariance.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::test {

/// What the sensors of a simulated robot gave in one interval, and where it really is at its end.
struct SimulatedStep {
  Motion motion;
  LandmarkObservationArray observations;
  Pose2 truth;
};

/// A robot on a circle between point landmarks: its motion and what it sees have exactly the noise
/// they claim. It starts at the origin; ids grow in no order of sight.
class SimulatedWorld {
 public:
  static constexpr int kLap = 126;  ///< steps of once around the circle

  explicit SimulatedWorld(std::uint64_t seed) : random_(seed, 0) {
    for (int i = 0; i < 8; ++i) {
      const double angle = 2 * M_PI * i / 8;
      landmarks_[10 + (3 * i) % 8] =
          centre() + 6.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      landmarks_[50 - i] = centre() + 1.5 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    Q_ << 4e-5, 0, 0, 0, 1e-5, 5e-6, 0, 5e-6, 2e-5;
    R_ << 25e-4, 0, 0, 1e-4;
  }

  /// The same among landmarks of these places.
  SimulatedWorld(std::uint64_t seed, std::map<LandmarkId, Eigen::Vector2d> landmarks)
      : SimulatedWorld(seed) {
    landmarks_ = std::move(landmarks);
  }

  const std::map<LandmarkId, Eigen::Vector2d>& landmarks() const { return landmarks_; }

  SimulatedStep next() {
    SimulatedStep step;
    step.motion = drive();
    step.observations = look();
    step.truth = truth_;
    ++count_;
    return step;
  }

 private:
  static Eigen::Vector2d centre() { return {0.0, 4.0}; }
  Stamp stamp(std::uint64_t count) const {
    return stampFromNanoseconds(1000000000000) + count * std::chrono::milliseconds(100);
  }
  template <int N>
  Eigen::Matrix<double, N, 1> noise(const Eigen::Matrix<double, N, N>& covariance) {
    Eigen::Matrix<double, N, 1> white;
    for (auto& element : white) element = random_.gaussian();
    return withCovariance(covariance, white);
  }

  Motion drive() {
    Motion motion;
    motion.sequence = count_;
    motion.start = stamp(count_);
    motion.end = stamp(count_ + 1);
    motion.increment = Pose2::exp({0.2, 0.0, 0.05});
    motion.covariance = Q_;
    motion.odometry_start = odometry_;
    odometry_ = motion.odometry_end = odometry_ * motion.increment;
    motion.odometry_frame = "odom";
    motion.base_frame = "base_link";
    truth_ = truth_ * Pose2::fromVector(motion.increment.vector() + noise<3>(Q_));
    return motion;
  }

  LandmarkObservationArray look() {
    LandmarkObservationArray array;
    array.sequence = count_;
    array.stamp = stamp(count_ + 1);
    array.sensor_frame = "camera";
    array.sensor_pose = Pose2(0.2, -0.05, 0.1);
    const Pose2 T_sensor_map = (truth_ * array.sensor_pose).inverse();
    for (const auto& [id, m_map] : landmarks_) {
      const auto m_sensor = T_sensor_map.transform(m_map);
      if (m_sensor.norm() > 5.0 || m_sensor.norm() < 0.5) continue;
      const auto error = noise<2>(R_);
      LandmarkObservation z;
      z.id = id;
      z.range = m_sensor.norm() + error.x();
      z.bearing = std::atan2(m_sensor.y(), m_sensor.x()) + error.y();
      z.covariance = R_;
      array.observations.push_back(z);
    }
    return array;
  }

  RandomStream random_;
  std::map<LandmarkId, Eigen::Vector2d> landmarks_;
  Eigen::Matrix3d Q_;
  Eigen::Matrix2d R_;
  Pose2 truth_, odometry_;
  std::uint64_t count_ = 0;
};

/// (truth - estimate) weighted with the estimate's covariance; 3 expected.
inline double nees(const Pose2& truth, const Pose2& estimate, const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d error(truth.x() - estimate.x(), truth.y() - estimate.y(),
                              std::remainder(truth.theta() - estimate.theta(), 2 * M_PI));
  return squaredDistance(error, covariance);
}

}  // namespace slam::test
