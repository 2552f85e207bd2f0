// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_gap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam {
namespace {

/// Increments of which a rate is made: what a shorter one has at least, a floor, would make it
/// large.
constexpr Duration kSpan = std::chrono::milliseconds(100);
constexpr double kStep = 0.1;     // [s] of the pieces in which errors of heading carry on
constexpr int kMostSteps = 1000;  // of longer gaps the pieces are longer
constexpr Duration kRounding = std::chrono::microseconds(1);  // of stamps in floating point
constexpr int kMayReturn = 1000;  // motions after which stamps that jumped are those of time
// A process that is started again takes some seconds.
constexpr Duration kLongestPause = std::chrono::seconds(60);
constexpr Duration kLongestCoasting = std::chrono::seconds(10);  // after a resumption
constexpr double kSamePose = 1e-6;                               // [m], [rad]

/// Older than that by more, it is the first of a new run.
bool isLate(const Motion& before, const Motion& after) {
  return after.end <= before.end && after.end > before.end - kStampJump;
}

bool isGap(const Motion& before, const Motion& after) {
  return after.start > before.end + kRounding && after.base_frame == before.base_frame;
}

/// Whether motion that usually comes more often is missing in this one, or the robot stood.
bool isPause(const Motion& motion, const UsualInterval& usual) {
  constexpr Duration kLongestGuess = std::chrono::seconds(1);
  return usual.isExceededBy(motion.end - motion.start, kLongestGuess);
}

bool hasMoved(const Motion& motion) {
  constexpr double kStands = 0.05;  // [m], [rad]
  return motion.increment.position().norm() > kStands ||
         std::abs(motion.increment.theta()) > kStands;
}

bool mayCoast(Duration pause) { return pause > Duration() && pause <= kLongestCoasting; }

/// What is missing between the two, but for what it was.
Motion between(const Motion& before, const Motion& after) {
  Motion rest = before;
  rest.start = before.end;
  rest.end = after.start;
  rest.odometry_start = before.odometry_end;
  rest.odometry_end = after.odometry_start;
  return rest;
}

/// Integrates the squared distance to the end of a gap over the time of the gap, with the largest
/// distance that the robot may have had at each moment: it is not larger than the way still to be
/// driven, nor than `step` and the way driven already. The rate of the heading's variance times
/// this is what the variance of the position grows by.
/// @param time [s] @param step from one end of the gap to the other [m]
/// @param speed at which the robot drove, step / time at least [m/s] @return [m^2 s]
double squaredLever(double time, double step, double speed) {
  if (speed <= 0.0) return 0.0;
  const double furthest = 0.5 * (speed * time + step);  // where both bounds are the same
  return (2.0 * std::pow(furthest, 3) - std::pow(step, 3)) / (3.0 * speed);
}

/// The heading's error adds this to the variance of the position at most, where the way was longer
/// than the shortest arc [m^2]. @param rate variance of the heading [rad^2/s]
double varianceOfDetour(const Pose2& increment, double time, double largest_speed, double rate) {
  const double step = increment.position().norm(), arc = increment.log().head<2>().norm();
  if (step == 0.0 && increment.theta() == 0.0) return 0.0;  // its wheels did not turn
  constexpr double kMost = 0.1 * kLargestInputSigmaLength * kLargestInputSigmaLength;
  const double shortest = arc / time;
  return std::min(kMost, rate * (squaredLever(time, step, std::max(shortest, largest_speed)) -
                                 squaredLever(time, step, shortest)));
}

double way(const Eigen::Matrix3d& covariance) { return covariance.topLeftCorner<2, 2>().trace(); }

/// The worse of both by its way, and by its turn, which have no unit in common.
Eigen::Matrix3d worse(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Matrix3d& by_way = way(b) > way(a) ? b : a;
  const double turn = std::max(a(2, 2), b(2, 2));
  const Eigen::Vector3d growth(1.0, 1.0, std::sqrt(turn / by_way(2, 2)));
  return growth.asDiagonal() * by_way * growth.asDiagonal();
}

}  // namespace

MotionGap::Bridge MotionGap::bridge(Motion& motion) {
  unknown_way_ = std::nullopt;
  if (last_ && isLate(*last_, motion)) return Bridge::kNone;
  went_on_ = std::nullopt;
  const auto resumed_after = std::exchange(resumed_after_, std::nullopt);
  if (resumed_after && last_) went_on_ = wentOn(*last_, motion, *resumed_after);
  const bool is_unknown = went_on_ == false;
  if (is_unknown && !mayCoast(motion.end - last_->end)) {
    reset();
    went_on_ = false;
    return Bridge::kUnknown;
  }
  const auto before = predecessorOf(motion);
  const auto usual = usual_;
  const bool is_pause = isPause(motion, usual);
  const bool stood = is_pause && usual_step_.countOf(motion.increment);
  const bool is_of_burst = usual.isOfBurst(motion.end - motion.start);
  usual_.note(motion.end - motion.start);
  usual_step_.note(motion.increment);
  last_ = motion;
  if (!is_of_burst && (!is_pause || worst_rate_.isZero())) learnRate(motion);
  learnScales(motion);
  const bool is_gap = before && isGap(*before, motion);
  const bool tells = is_gap && !is_unknown && posesTell(*before, motion);
  const auto own_end = is_gap ? motion.start : motion.end;
  if (is_pause && !stood) motion.covariance = worse(motion.covariance, onAnyWay(motion).covariance);
  if (is_gap) motion = joined(tells ? across(*before, motion) : coasted(*before, motion), motion);
  if (isPause(motion, usual) && hasMoved(motion)) unknown_way_ = {motion.start, own_end};
  if (!is_of_burst && !stood) coasting_.add(last_->increment, last_->end - last_->start);
  if (!is_gap) return Bridge::kNone;
  return tells ? Bridge::kByPoses : Bridge::kByVelocity;
}

/// Stamps that jumped may do so back, where the motion before the jump is what goes on.
std::optional<Motion> MotionGap::predecessorOf(const Motion& motion) {
  if (!last_) return std::nullopt;
  const bool jumps = motion.end > last_->end + kStampJump || motion.end <= last_->end;
  if (!jumps) {
    if (++since_jump_ > kMayReturn) before_jump_.reset();
    return last_;
  }
  since_jump_ = 0;
  const auto other = std::exchange(before_jump_, last_);
  const bool fits = other && other->end <= motion.start;
  return fits && (last_->end > motion.start || other->end > last_->end) ? other : last_;
}

/// Not where it was restarted meanwhile.
bool MotionGap::posesTell(const Motion& before, const Motion& after) const {
  const auto interval = after.start - before.end;
  const Pose2 step = before.odometry_end.between(after.odometry_start);
  const bool was_restarted = isOrigin(after.odometry_start) && coasting_.isUnusual(step, interval);
  return after.odometry_frame == before.odometry_frame && isPossible(step, interval) &&
         !was_restarted;
}

/// A driver that was restarted begins at its origin. One that was restarted earlier than this
/// process has left it already; then the step may look unusual.
bool MotionGap::wentOn(const Motion& before, const Motion& after, Interruption interruption) const {
  const auto pause = after.end - before.end;
  const Pose2 step = before.odometry_end.between(after.odometry_end);
  const bool is_at_origin = isOrigin(after.odometry_start) || isOrigin(after.odometry_end);
  const bool was_restarted = is_at_origin && !isOrigin(before.odometry_end);
  const bool is_missing = after.start > before.end + kRounding;
  const Pose2 jump = before.odometry_end.between(after.odometry_start);
  return pause > Duration() && pause <= kLongestPause &&
         after.odometry_frame == before.odometry_frame && after.base_frame == before.base_frame &&
         !was_restarted && isPossible(step, pause) &&
         (interruption == Interruption::kOfThisProcess || !coasting_.isUnusual(step, pause)) &&
         (is_missing || jump.vector().norm() < kSamePose);
}

/// Until there is a whole span a part of one must do.
void MotionGap::learnRate(const Motion& motion) {
  span_ += motion.end - motion.start;
  span_covariance_ += motion.covariance;
  const bool is_whole = span_ >= kSpan;
  if (!is_whole && knows_rate_) return;
  const Eigen::Matrix3d rate = span_covariance_ / seconds(span_);
  worst_rate_ = knows_rate_ ? worse(worst_rate_, rate) : rate;
  if (!is_whole) return;
  knows_rate_ = true;
  span_ = {};
  span_covariance_.setZero();
}

void MotionGap::learnScales(const Motion& motion) {
  const Eigen::Vector3d told = motion.increment.log();
  const Pose2 step = motion.odometry_start.between(motion.odometry_end);
  if (!isPossible(step, motion.end - motion.start)) return;
  const Eigen::Vector3d measured = step.log();
  way_scale_.add(told.head<2>().dot(measured.head<2>()), measured.head<2>().squaredNorm());
  turn_scale_.add(told.z() * measured.z(), measured.z() * measured.z());
}

Pose2 MotionGap::scaled(const Pose2& measured) const {
  Eigen::Vector3d twist = measured.log();
  twist.head<2>() *= way_scale_.value();
  twist.z() *= turn_scale_.value();
  return Pose2::exp(twist);
}

Motion MotionGap::across(const Motion& before, const Motion& after) const {
  Motion rest = between(before, after);
  rest.increment = scaled(rest.odometry_start.between(rest.odometry_end));
  const auto steps = usual_step_.countOf(rest.increment);
  if (!steps) return onAnyWay(std::move(rest));
  rest.covariance = *steps * seconds(usual_.value()) * worst_rate_;
  return rest;
}

/// @return the motion with the covariance that it has if only both of its ends are known
Motion MotionGap::onAnyWay(Motion rest) const {
  const double time = seconds(rest.end - rest.start);
  rest.covariance = time * worst_rate_;
  const double detour =
      varianceOfDetour(rest.increment, time, coasting_.largestSpeed(), worst_rate_(2, 2));
  std::optional<Motion> sum;
  for (int left = std::clamp(static_cast<int>(std::ceil(time / kStep)), 1, kMostSteps); left > 1;
       --left) {
    auto [piece, after_piece] = split(rest, rest.start + (rest.end - rest.start) / left);
    sum = sum ? joined(*sum, piece) : piece;
    rest = after_piece;
  }
  auto crossed = sum ? joined(*sum, rest) : rest;
  crossed.covariance.topLeftCorner<2, 2>() += detour * Eigen::Matrix2d::Identity();
  return crossed;
}

Motion MotionGap::coasted(const Motion& before, const Motion& after) const {
  Motion rest = between(before, after);
  const auto interval = rest.end - rest.start;
  rest.increment = coasting_.increment(interval);
  rest.covariance = coasting_.covariance(interval) + seconds(interval) * worst_rate_;
  rest.odometry_start = rest.odometry_end * rest.increment.inverse();
  return rest;
}

}  // namespace slam
