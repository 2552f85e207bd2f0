// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam::test {

/// A robot that drives in a circle among landmarks that nobody can tell apart but by their places.
class Grove {
 public:
  explicit Grove(std::uint64_t seed) : random_(seed, 0) {
    constexpr int kTrees = 60;
    constexpr double kEdge = 30.0;  // [m]
    for (int i = 0; i < kTrees; ++i)
      trees_.emplace_back(kEdge * random_.uniform(), kEdge * random_.uniform());
  }

  Motion drive() {
    Motion motion;
    motion.sequence = count_;
    motion.start = stamp();
    ++count_;
    motion.end = stamp();
    motion.increment = Pose2::exp({0.2, 0.0, 0.025});  // a circle of 8 m radius
    motion.covariance = Eigen::Vector3d(4e-5, 1e-5, 2e-5).asDiagonal();
    motion.odometry_start = odometry_;
    odometry_ = motion.odometry_end = odometry_ * motion.increment;
    truth = truth * motion.increment;
    return motion;
  }
  /// @param tells_ids whether the trees are told apart by ids, which are their numbers
  LandmarkObservationArray look(bool tells_ids = false) {
    LandmarkObservationArray array;
    array.sequence = count_;
    array.stamp = stamp();
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      const auto place = truth.inverse().transform(trees_[i]);
      constexpr double kReach = 7.0, kSigma = 0.03, kSigmaBearing = 0.01;  // [m], [m], [rad]
      if (place.norm() > kReach || place.norm() < 0.5 || random_.uniform() < 0.05) continue;
      LandmarkObservation z;
      if (tells_ids) z.id = static_cast<LandmarkId>(i);
      z.range = place.norm() + kSigma * random_.gaussian();
      z.bearing = std::atan2(place.y(), place.x()) + kSigmaBearing * random_.gaussian();
      z.covariance << kSigma * kSigma, 0.0, 0.0, kSigmaBearing * kSigmaBearing;
      array.observations.push_back(z);
    }
    return array;
  }

  const std::vector<Eigen::Vector2d>& trees() const { return trees_; }

  Pose2 truth{15.0, 7.0, 0.0};

 private:
  Stamp stamp() const {
    return stampFromNanoseconds(1000000000000) + count_ * std::chrono::milliseconds(100);
  }

  RandomStream random_;
  std::vector<Eigen::Vector2d> trees_;
  Pose2 odometry_;
  std::uint64_t count_ = 0;
};

/// A robot that maps a grove with one of the back-ends.
struct GroveRobot {
  /// @param association by which the trees are told apart; their ids are known to "known_ids" only
  void configure(const std::string& backend, const std::string& association) {
    tells_ids = association == "known_ids";
    Settings settings({}, {}, {"association=" + association});
    estimator.use(Registry<Backend>::instance().create(backend));
    estimator.configure(settings);
  }
  void step() {
    estimator.set(grove.drive());
    estimator.set(grove.look(tells_ids));
    for (estimator.execute(); estimator.report(); estimator.execute()) report = *estimator.report();
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) step();
  }
  /// Lifts the robot, and puts it down elsewhere on its way.
  void carry(int steps) {
    grove.truth = grove.truth * Pose2::exp(steps * Eigen::Vector3d(0.2, 0.0, 0.025));
  }
  Pose2 inMap(const Pose2& pose) const { return start.inverse() * pose; }
  double error() const {
    return (report.pose.pose.position() - inMap(grove.truth).position()).norm();
  }
  LandmarkMap landmarks() const {
    return estimator.capabilities().find<LandmarkMapper>()->landmarks();
  }

  static constexpr int kLap = 252;  // steps
  Grove grove{1};
  const Pose2 start = grove.truth;
  Estimator estimator;
  StepReport report;
  bool tells_ids = false;
};

}  // namespace slam::test
