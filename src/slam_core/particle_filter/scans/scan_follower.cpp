// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_follower.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/geometry/principal_axes.hpp"

namespace slam::particle_filter {
namespace {

constexpr double kMetresPerRadian = 0.5;  // a turn errs as much as such a way

/// The part of a growth of the covariance that is neither negative nor more than the wheels' noise:
/// in directions that a scan does not tell, the way is as certain as the wheels say. There the
/// matcher has to allow for a slip, but nobody has seen one.
Eigen::Matrix3d withinNoise(const Eigen::Matrix3d& growth, const Eigen::Matrix3d& noise) {
  constexpr double kFloor = 1e-12;
  const Eigen::LLT<Eigen::Matrix3d> root(noise + kFloor * Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d L = root.matrixL();
  const Eigen::Matrix3d half = L.triangularView<Eigen::Lower>().solve(growth);
  const Eigen::Matrix3d relative =
      L.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d(half.transpose()));
  const auto [shares, V] = principalAxes(symmetric(relative));
  const Eigen::Matrix3d LV = L * V;
  return LV * shares.cwiseMax(0.0).cwiseMin(1.0).asDiagonal() * LV.transpose();
}

Eigen::Matrix3d turnOf(const Pose2& increment) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = increment.rotation();
  return turn;
}

/// The part of an error that is left, for errors in the frame where the robot was before it moved.
Eigen::Matrix3d beforeMotion(const Pose2& increment, const Eigen::Matrix3d& left) {
  const Eigen::Matrix3d turn = turnOf(increment);
  return turn * left * turn.transpose();
}

/// The other way round.
Eigen::Matrix3d afterMotion(const Pose2& increment, const Eigen::Matrix3d& left) {
  const Eigen::Matrix3d turn = turnOf(increment);
  return turn.transpose() * left * turn;
}

}  // namespace

Motion corrected(const Motion& motion, const ScanCorrection& correction) {
  const Eigen::Matrix3d left = beforeMotion(motion.increment, correction.left);
  Motion after = motion;
  after.increment = motion.increment * correction.pose;
  after.covariance = left * motion.covariance * left.transpose();
  return after;
}

Pose2 corrected(const Pose2& deviation, const Pose2& motion, const ScanCorrection& correction) {
  return Pose2::fromVector(beforeMotion(motion, correction.left) * deviation.vector());
}

ScanFollower::ScanFollower(const scan_matching::MatcherConfig& matcher, const Drift& drift)
    : variance_per_metre_(std::pow(drift.position, 2), std::pow(drift.position, 2),
                          std::pow(drift.heading, 2)),
      tracker_(matcher) {}

void ScanFollower::restart() {
  tracker_.restart({});
  wheels_.reset();
  correction_ = {};
  beginMotion();
}

void ScanFollower::move(const Motion& motion) {
  wheels_ = wheels_ ? joined(*wheels_, motion) : motion;
}

scan_matching::Match ScanFollower::follow(const scan_matching::MapView& map,
                                          const scan_matching::ScanLevels& scan, Stamp stamp,
                                          const Pose2& pose,
                                          const std::optional<Eigen::Matrix3d>& drift) {
  const auto wheels = std::exchange(wheels_, std::nullopt).value_or(Motion());
  tracker_.moveTo(pose * wheels.increment.inverse());
  const auto before = tracker_.robot();
  const auto found = tracker_.track(map, scan, stamp, wheels, drift);
  const auto& after = tracker_.robot();
  correction_ = {pose.between(after.pose),
                 afterMotion(tracker_.step().increment, tracker_.step().of_motion)};
  Motion step;
  step.increment = before.pose.between(after.pose);
  Eigen::Matrix3d J_before, J_u;
  before.pose.compose(step.increment, &J_before, &J_u);
  const Eigen::Matrix3d growth =
      after.covariance - J_before * before.covariance * J_before.transpose();
  const double way =
      step.increment.position().norm() + kMetresPerRadian * std::abs(step.increment.theta());
  step.covariance = withinNoise(J_u.transpose() * growth * J_u, wheels.covariance);
  step.covariance.diagonal() += way * variance_per_metre_;
  motion_ = joined(motion_, step);
  return found;
}

}  // namespace slam::particle_filter
