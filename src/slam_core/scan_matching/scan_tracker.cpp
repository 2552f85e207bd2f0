// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/scan_matching/motion_prior.hpp"

namespace slam::scan_matching {
namespace {

constexpr double kLeast = 0.02;   // interval that tells a velocity [s]
constexpr double kFading = 0.8;   // of a velocity that no scan confirms
constexpr double kMemory = 50.0;  // scans that the usual interval is the mean of, about

/// Of a robot that speeds up, brakes and turns as it likes since its last velocity.
Eigen::Matrix3d noiseOfVelocity(Duration interval) {
  constexpr double kAcceleration = 2.0;         // [m/s^2]
  constexpr double kTurningAcceleration = 4.0;  // [rad/s^2]
  const double squared = std::pow(seconds(interval), 2);
  const double way = kAcceleration * squared, turn = kTurningAcceleration * squared;
  return Eigen::Vector3d(way * way, way * way, turn * turn).asDiagonal();
}

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& P) { return 0.5 * (P + P.transpose()); }

Eigen::Matrix3d covarianceAfter(const PoseEstimate& robot, const Motion& motion) {
  Eigen::Matrix3d J_pose, J_u;
  robot.pose.compose(motion.increment, &J_pose, &J_u);
  return symmetric(J_pose * robot.covariance * J_pose.transpose() +
                   J_u * motion.covariance * J_u.transpose());
}

}  // namespace

void SweepInterval::note(Duration interval) {
  const double dt = seconds(interval);
  if (usual_ == 0.0) usual_ = dt;
  spread_ += (std::abs(dt - usual_) - spread_) / kMemory;
  usual_ += (dt - usual_) / kMemory;
}

Duration SweepInterval::plausible(Duration interval) const {
  constexpr double kIrregular = 0.5, kLongest = 3.0;  // of the usual interval
  if (usual_ == 0.0) return interval;
  if (spread_ > kIrregular * usual_) return durationFromSeconds(usual_);
  return std::min(interval, durationFromSeconds(kLongest * usual_));
}

void ScanTracker::restart(const PoseEstimate& place) {
  robot_ = place;
  stamp_.reset();
  sweeps_ = {};
  velocity_.setZero();
}

/// By the last velocity.
Motion ScanTracker::motionOf(Duration interval) const {
  Motion motion;
  motion.increment = Pose2::exp(seconds(interval) * velocity_);
  motion.covariance = noiseOfVelocity(interval);
  return motion;
}

Match ScanTracker::track(const MapView& map, const ScanLevels& scan, Stamp stamp,
                         const std::optional<Motion>& told) {
  Duration interval{};
  if (stamp_ && stamp > *stamp_) {
    interval = sweeps_.plausible(stamp - *stamp_);
    sweeps_.note(stamp - *stamp_);
  }
  const auto motion = told ? *told : motionOf(interval);
  const auto prior =
      priorAfter(robot_.pose, robot_.covariance, motion.increment, motion.covariance);
  Match found;
  found.pose = prior.pose;
  if (map.isEmpty()) {
    robot_.covariance = covarianceAfter(robot_, motion);
  } else {
    found = matcher_.match(map, scan, prior);
    robot_.covariance =
        symmetric((found.prior_weight * prior.information + found.information).inverse());
  }
  if (interval > Duration::zero())
    follow(robot_.pose.between(found.pose), found.is_determined, interval);
  robot_.pose = found.pose;
  stamp_ = stamp;
  return found;
}

void ScanTracker::follow(const Pose2& step, bool is_confirmed, Duration interval) {
  if (is_confirmed)
    velocity_ = step.log() / std::max(kLeast, seconds(interval));
  else
    velocity_ *= kFading;
}

bool InsertionTrigger::isDue(const Pose2& pose) const {
  if (!last_) return true;
  const Pose2 step = last_->between(pose);
  return step.position().norm() >= distance_ || std::abs(step.theta()) >= angle_;
}

}  // namespace slam::scan_matching
