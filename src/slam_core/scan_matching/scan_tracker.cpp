// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/scan_matching/motion_prior.hpp"

namespace slam::scan_matching {
namespace {

constexpr double kLeast = 0.02;        // interval that shows a velocity [s]
constexpr double kFading = 0.8;        // of a velocity, by a scan that fits nothing
constexpr double kConfirmed = 0.5;     // share of a step that a scan determines
constexpr double kFastest = 1.0;       // by which a velocity may be off [m/s], [rad/s]
constexpr double kSweepsMeant = 50.0;  // scans that the usual interval is the mean of, about

/// Standard deviations [m/s^2], [rad/s^2]. kHardest: in a step, the change of the velocity is
/// clamped to this many times the acceleration's standard deviation times dt.
constexpr double kAcceleration = 2.0, kTurningAcceleration = 4.0, kHardest = 1.5;

/// The covariance of a robot that speeds up, brakes and turns as it likes. Its last velocity is the
/// mean over the interval before: under a constant acceleration a, the mean over this one differs
/// by a dt, which makes a way of a dt^2. (From the velocity at the end of the interval before it
/// would be half of that: Bar-Shalom, Li, Kirubarajan 2001, sec. 6.3.)
Eigen::Matrix3d noiseOfVelocity(Duration interval) {
  const double squared = std::pow(seconds(interval), 2);
  const double way = kAcceleration * squared, turn = kTurningAcceleration * squared;
  return Eigen::Vector3d(way * way, way * way, turn * turn).asDiagonal();
}

/// Of the error of a prior, in each of the robot's directions, what a scan determines.
Eigen::Vector3d sharesOf(const Match& found, const PosePrior& prior) {
  if (!found.is_determined) return Eigen::Vector3d::Zero();
  Eigen::Matrix3d to_robot = Eigen::Matrix3d::Identity();
  to_robot.topLeftCorner<2, 2>() = prior.pose.rotation().transpose();
  const Eigen::Matrix3d gain =
      (prior.information + found.information).inverse() * found.information;
  const Eigen::Matrix3d of_robot = to_robot * gain * to_robot.transpose();
  return of_robot.diagonal().cwiseMax(0.0).cwiseMin(1.0);
}

/// The motion is by far less certain than the window in which a scan is searched around it.
bool leadsAnywhere(const Motion& motion) {
  constexpr double kPosition = 1.0, kHeading = 0.5;  // [m], [rad]
  const Eigen::Matrix3d& P = motion.covariance;
  const double widest = largestVariance(P.topLeftCorner<2, 2>());
  return widest > kPosition * kPosition || P(2, 2) > kHeading * kHeading;
}

}  // namespace

void SweepInterval::note(Duration interval) {
  const double dt = seconds(interval);
  if (usual_ == 0.0) usual_ = dt;
  spread_ += (std::abs(dt - usual_) - spread_) / kSweepsMeant;
  usual_ += (dt - usual_) / kSweepsMeant;
}

Duration SweepInterval::plausible(Duration interval) const {
  constexpr double kLongest = 3.0;  // of the usual interval
  if (usual_ == 0.0) return interval;
  return std::min(likely(interval), durationFromSeconds(kLongest * usual_));
}

Duration SweepInterval::likely(Duration interval) const {
  constexpr double kIrregular = 0.5;  // of the usual interval
  return spread_ > kIrregular * usual_ ? durationFromSeconds(usual_) : interval;
}

void ScanTracker::restart(const PoseEstimate& place) {
  robot_ = place;
  step_ = {};
  stamp_.reset();
  wide_search_.reset();
  slip_ = {};
  sweeps_ = {};
  velocity_.setZero();
  shares_.setZero();
  was_known_.setConstant(true);
  unconfirmed_.setZero();
  is_anywhere_ = false;
}

/// The robot is taken to go on at its last velocity, and to have turned as measured where that is
/// known. If no scan has confirmed the velocity for a time, its error grows with that time.
Motion ScanTracker::motionOf(Duration interval, const std::optional<Turn>& turn) const {
  const double dt = seconds(interval);
  Eigen::Vector3d twist = dt * velocity_;
  if (turn) twist.z() = turn->angle;
  Motion motion;
  motion.increment = Pose2::exp(twist);
  motion.covariance = noiseOfVelocity(interval);
  const Eigen::Array3d grown = (unconfirmed_ + dt).square() - unconfirmed_.square();
  motion.covariance.diagonal().array() +=
      kFastest * kFastest * (unconfirmed_ > 0.0).select(grown, 0.0);
  if (turn) motion.covariance(2, 2) = turn->variance;
  return motion;
}

ScanTracker::Intervals ScanTracker::intervalsTo(Stamp stamp) {
  if (!stamp_ || stamp <= *stamp_) return {};
  const Duration interval = stamp - *stamp_;
  const Intervals intervals{sweeps_.plausible(interval), sweeps_.likely(interval)};
  sweeps_.note(interval);
  return intervals;
}

Match ScanTracker::track(const MapView& map, const ScanLevels& scan, Stamp stamp,
                         const std::optional<Motion>& told,
                         const std::optional<Eigen::Matrix3d>& drift) {
  const auto intervals = intervalsTo(stamp);
  if (told) unconfirmed_.setZero();
  const auto motion = told ? *told : motionOf(intervals.plausible, std::nullopt);
  is_anywhere_ = is_anywhere_ || (told && !map.isEmpty() && leadsAnywhere(*told));
  return follow(map, scan, stamp, {motion, told.has_value(), drift}, intervals.likely);
}

Match ScanTracker::track(const MapView& map, const ScanLevels& scan, Stamp stamp,
                         const Turn& turn) {
  const auto intervals = intervalsTo(stamp);
  const auto motion = motionOf(intervals.plausible, turn);
  return follow(map, scan, stamp, {motion, false, std::nullopt, true}, intervals.likely);
}

Match ScanTracker::follow(const MapView& map, const ScanLevels& scan, Stamp stamp, const Way& way,
                          Duration gap) {
  const Pose2 before = robot_.pose;
  const bool may_match = !map.isEmpty() && !is_anywhere_;
  const auto found = may_match ? match(map, scan, stamp, way) : move(way.motion);
  if (gap > Duration::zero())
    learnVelocity(before.between(found.pose), gap, found.jumped || found.is_among_older);
  stamp_ = stamp;
  return found;
}

/// The robot moves without a match, since there is no map or no match could be believed.
Match ScanTracker::move(const Motion& motion) {
  Eigen::Matrix3d J_pose, J_u;
  Match found;
  found.pose = robot_.pose.compose(motion.increment, &J_pose, &J_u);
  found.is_anywhere = is_anywhere_;
  shares_.setZero();
  step_ = {motion.increment, motion.covariance, Eigen::Matrix3d::Identity()};
  robot_ = {found.pose, clampedHeading(symmetric(J_pose * robot_.covariance * J_pose.transpose() +
                                                 J_u * motion.covariance * J_u.transpose()))};
  return found;
}

bool ScanTracker::mayUseWideWindow(Stamp stamp) const {
  constexpr Duration kPause = std::chrono::milliseconds(500);
  if (!limits_.may_jump) return false;
  return !wide_search_ || stamp - *wide_search_ >= kPause || stamp < *wide_search_;
}

Match ScanTracker::match(const MapView& map, const ScanLevels& scan, Stamp stamp, const Way& way) {
  const auto& increment = way.motion.increment;
  Eigen::Matrix3d slip = (way.is_told ? slip_ : SlipEstimate()).covarianceOf(increment);
  if (way.has_turn) {
    slip.row(2).setZero();
    slip.col(2).setZero();
  }
  const Eigen::Matrix3d noise = way.motion.covariance + slip;
  auto prior = priorAfter(robot_.pose, robot_.covariance, increment, noise);
  prior.is_measured = way.is_told;
  if (way.is_told && way.drift)
    prior.information_among_older = (prior.information.inverse() + *way.drift).inverse();
  const auto found = matcher_.match(map, scan, prior, mayUseWideWindow(stamp));
  if (found.wide_search_done) wide_search_ = stamp;
  if (way.is_told && found.is_determined && !found.is_among_older)
    slip_.learn(increment, prior.pose.between(found.pose), sharesOf(found, prior));
  const auto usual = SlipEstimate().covarianceOf(increment);
  shares_ = sharesOf(found, priorAfter(robot_.pose, Eigen::Matrix3d::Zero(), increment, usual));
  if (found.is_among_older) prior.information = *prior.information_among_older;
  update(found, prior, way.motion, noise);
  return found;
}

// F, G: Jacobians of the predicted pose by the pose before and by the increment; P: covariance of
// the pose after the scan; K: the part of an error of the prior that the scan takes out, and left
// the rest of it, I - K; J_inverse, J_to_before, J_after: Jacobians of the inverse of the pose
// before, and of the step by this inverse and by the pose found; A, B: Jacobians of the step's
// error by those of the pose before and of the motion.
void ScanTracker::update(const Match& found, const PosePrior& prior, const Motion& motion,
                         const Eigen::Matrix3d& noise) {
  Eigen::Matrix3d prior_left = Eigen::Matrix3d::Zero();
  if (found.prior_weight > 0.0) prior_left = informationLeft(prior, found.pose, found.prior_weight);
  const Eigen::Matrix3d P = symmetric((prior_left + found.information).inverse());
  const Eigen::Matrix3d left = P * prior_left;  // I - K
  Eigen::Matrix3d F, G, J_inverse, J_to_before, J_after;
  robot_.pose.compose(motion.increment, &F, &G);
  step_.increment = robot_.pose.inverse(&J_inverse).compose(found.pose, &J_to_before, &J_after);
  const Eigen::Matrix3d A = J_after * left * F + J_to_before * J_inverse;
  const Eigen::Matrix3d B = step_.of_motion = J_after * left * G;
  step_.covariance = symmetric(A * robot_.covariance * A.transpose() + B * noise * B.transpose() +
                               J_after * P * found.information * P * J_after.transpose());
  robot_ = {found.pose, clampedHeading(P)};
}

void ScanTracker::learnVelocity(const Pose2& step, Duration interval, bool is_correction) {
  const double dt = seconds(interval);
  const Eigen::Vector3d seen = step.log() / std::max(kLeast, dt);
  const Eigen::Array3d most =
      kHardest * dt * Eigen::Array3d(kAcceleration, kAcceleration, kTurningAcceleration);
  const auto is_known = (shares_.array() > kConfirmed).eval();
  if (is_correction) was_known_.setConstant(false);
  const Eigen::Array3d shares = was_known_.select(is_known.select(1.0, shares_.array()), 0.0);
  if (shares_.isZero())
    velocity_ *= kFading;
  else
    velocity_.array() += (shares * (seen - velocity_).array()).min(most).max(-most);
  const Eigen::Array3d fastest(limits_.speed, limits_.speed, limits_.turn_rate);
  velocity_ = velocity_.array().min(fastest).max(-fastest);
  unconfirmed_ = (is_known && was_known_).select(0.0, unconfirmed_ + dt);
  was_known_ = is_known;
}

bool InsertionTrigger::isDue(const Pose2& pose) const {
  if (!last_) return true;
  const Pose2 step = last_->between(pose);
  return step.position().norm() >= distance_ || std::abs(step.theta()) >= angle_;
}

}  // namespace slam::scan_matching
