// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/wheel_odometry/wheel_odometry.hpp"

#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::wheel_odometry {
namespace {

const Registrar<OdometrySource, WheelOdometry> kRegistrar("wheel");
const SectionRegistrar<WheelOdometryConfig> kSectionRegistrar;

constexpr double kFarthest = 1e9;         // of a pose from its origin [m]
constexpr double kLargestVariance = 1e8;  // of a twist [m^2/s^2, rad^2/s^2]

bool isFinite(const OdometrySample& sample) {
  return sample.twist.allFinite() && (!sample.pose || sample.pose->isFinite());
}

bool isFar(const OdometrySample& sample) {
  return sample.pose && sample.pose->position().cwiseAbs().maxCoeff() > kFarthest;
}

}  // namespace

void WheelOdometry::configure(const WheelOdometryConfig& config) {
  validate(config);
  config_ = config;
  model_ = makeMotionModel(
      config.motion_model,
      {config.alpha1, config.alpha2, config.alpha3, config.alpha4,
       config.drive == WheelOdometryConfig::Drive::kOmnidirectional, config.alpha5, config.alpha6});
  limit_ = {config.max_speed, config.max_turn_rate};
  reset();
}

void WheelOdometry::configure(Settings& settings) {
  configure(settings.read<WheelOdometryConfig>());
}

void WheelOdometry::describe(Ports& ports) {
  ports.takes<OdometrySample>("odom", "odometry", this);
  ports.makes<Motion>("motion", motion_);
}

std::uint64_t WheelOdometry::dropped() const {
  return counters_["late"] + counters_["invalid"] + counters_["stamp_jump"] +
         counters_["implausible"];
}

void WheelOdometry::reset() {
  beginAnew();
  ahead_.reset();
  motion_.reset();
  odometry_pose_ = Pose2();
  next_sequence_ = 0;
  counters_.clear();
}

void WheelOdometry::beginAnew() {
  last_.reset();
  suspect_.reset();
  coasting_ = {};
  usual_ = {};
  has_twist_ = false;
}

Status WheelOdometry::execute() {
  motion_.reset();
  if (!isFinite(input_)) return reject("invalid", "odometry holds a value that is not a number");
  if (isFar(input_)) return reject("invalid", "odometry is more than 1e9 m from its origin");
  if (last_ && input_.stamp <= last_->stamp - kStampJump) beginAnew();
  if (last_ && input_.stamp <= last_->stamp)
    return reject("late",
                  input_.stamp == Stamp()
                      ? "odometry has the stamp 0, since its driver sets none; it is left out"
                      : "odometry is not newer than the message before it");
  if (isDoubtful())
    return reject("stamp_jump",
                  "odometry is stamped far ahead of the message before it; it counts "
                  "once the next one is ahead as well");
  const bool same_frames = last_ && input_.odometry_frame == last_->odometry_frame &&
                           input_.base_frame == last_->base_frame;
  if (!same_frames) return changeFrames();
  return followsPoses(input_) ? followPose() : followTwist();
}

bool WheelOdometry::followsPoses(const OdometrySample& sample) const {
  return config_.increment == WheelOdometryConfig::Increment::kPose && sample.pose && last_->pose;
}

Status WheelOdometry::changeFrames() {
  const bool changed = last_.has_value();
  odometry_pose_ = input_.pose.value_or(Pose2());
  last_ = input_;
  suspect_.reset();
  if (!changed) return Status::ok();
  return reject("frame_change", "odometry frames changed to " + input_.odometry_frame + " -> " +
                                    input_.base_frame + "; the motion in between is lost");
}

Status WheelOdometry::followPose() {
  const double share = shareFrom(*last_), from_suspect = suspect_ ? shareFrom(*suspect_) : 0.0;
  const bool returns = suspect_ && share <= 1.0 && share <= from_suspect;
  if (returns || (!suspect_ && !isSuspect(input_))) {
    auto motion = motionBetween(*last_, input_, last_->pose->between(*input_.pose));
    motion.odometry_start = odometry_pose_;
    take(motion);
    return Status::ok();
  }
  if (suspect_ && from_suspect <= 1.0) return crossJump();
  suspect_ = input_;
  return reject("implausible",
                "odometry's pose moved further than wheel_odometry.max_speed, max_turn_rate and "
                "its last motion allow; it is left out unless the next one is near it");
}

bool WheelOdometry::isSuspect(const OdometrySample& sample) const {
  const Pose2 step = last_->pose->between(*sample.pose);
  const Duration interval = sample.stamp - last_->stamp;
  return !(limit_.shareOf(step, interval) <= 1.0) ||
         (isOrigin(*sample.pose) && coasting_.isUnusual(step, interval));
}

double WheelOdometry::shareFrom(const OdometrySample& sample) const {
  return limit_.shareOf(sample.pose->between(*input_.pose), input_.stamp - sample.stamp);
}

Status WheelOdometry::crossJump() {
  auto motion = motionBetween(*suspect_, input_, suspect_->pose->between(*input_.pose));
  motion.odometry_start = *suspect_->pose;
  auto before = unmeasuredTo(*suspect_);
  before.odometry_end = *suspect_->pose;
  before.odometry_start = before.odometry_end * before.increment.inverse();
  take(joined(before, motion));
  return reject("pose_jump",
                "odometry's pose jumped, as that of a driver that was restarted; it goes on from "
                "the new one, and the motion in between is taken from the last velocity");
}

Status WheelOdometry::followTwist() {
  constexpr Duration kLongestHold = std::chrono::seconds(2);  // of a twist that is not in doubt
  const bool is_possible = limit_.allows(last_->twist);
  const auto interval = input_.stamp - last_->stamp;
  auto motion = is_possible
                    ? motionBetween(*last_, input_, Pose2::exp(seconds(interval) * last_->twist))
                    : unmeasuredTo(input_);
  if (is_possible && usual_.isExceededBy(interval, kLongestHold))
    motion.covariance += coasting_.covariance(interval);
  motion.odometry_start = odometry_pose_;
  take(motion);
  if (is_possible) return Status::ok();
  return reject("implausible",
                "odometry's twist is beyond wheel_odometry.max_speed or max_turn_rate; the motion "
                "is taken from the last velocity");
}

void WheelOdometry::take(const Motion& motion) {
  motion_ = motion;
  motion_->sequence = next_sequence_++;
  odometry_pose_ = motion_->odometry_end;
  coasting_.add(motion.increment, motion.end - motion.start);
  usual_.note(motion.end - motion.start);
  has_twist_ = has_twist_ || (!input_.twist.isZero(0.0) && limit_.allows(input_.twist));
  last_ = input_;
  suspect_.reset();
}

Motion WheelOdometry::motionBetween(const OdometrySample& from, const OdometrySample& to,
                                    const Pose2& measured) const {
  Motion motion;
  motion.start = from.stamp;
  motion.end = to.stamp;
  motion.increment = calibrated(measured);
  motion.covariance = covarianceOf(motion.increment, from, motion.end - motion.start);
  motion.odometry_end = to.pose.value_or(odometry_pose_ * measured);
  motion.odometry_frame = to.odometry_frame;
  motion.base_frame = to.base_frame;
  return motion;
}

Motion WheelOdometry::unmeasuredTo(const OdometrySample& sample) const {
  const auto interval = sample.stamp - last_->stamp;
  const bool twist_tells = has_twist_ && limit_.allows(last_->twist);
  auto motion = motionBetween(
      *last_, sample,
      twist_tells ? Pose2::exp(seconds(interval) * last_->twist) : coasting_.increment(interval));
  if (!twist_tells) motion.increment = coasting_.increment(interval);  // is calibrated already
  motion.covariance += coasting_.covariance(interval);
  return motion;
}

bool WheelOdometry::isDoubtful() {
  const auto ahead = std::exchange(ahead_, std::nullopt);
  const bool confirms = ahead && input_.stamp > ahead->stamp;
  if (last_ && !confirms && input_.stamp > last_->stamp + kStampJump) {
    ahead_ = input_;
    return true;
  }
  if (last_ && confirms && followsPoses(*ahead) && isSuspect(*ahead)) suspect_ = ahead;
  return false;
}

Status WheelOdometry::reject(const std::string& reason, const std::string& sentence) {
  counters_.add(reason);
  return Status::warning(sentence);
}

Pose2 WheelOdometry::calibrated(const Pose2& increment) const {
  if (config_.translation_scale == 1.0 && config_.rotation_scale == 1.0 && config_.drift == 0.0)
    return increment;
  Eigen::Vector3d twist = increment.log();
  twist.head<2>() *= config_.translation_scale;
  twist.z() = config_.rotation_scale * twist.z() + config_.drift * twist.x();
  return Pose2::exp(twist);
}

Eigen::Matrix3d WheelOdometry::covarianceOf(const Pose2& increment, const OdometrySample& from,
                                            Duration interval) const {
  const double dt = seconds(interval);
  const double position = config_.floor_position * config_.floor_position * dt;
  const double heading = config_.floor_heading * config_.floor_heading * dt;
  const Eigen::Matrix3d floor = Eigen::Vector3d(position, position, heading).asDiagonal();
  const auto& twist = from.twist_covariance;
  const bool given = config_.covariance == WheelOdometryConfig::Covariance::kTwist &&
                     isCovariance(twist) && twist.cwiseAbs().maxCoeff() <= kLargestVariance;
  return floor + (given ? dt * dt * twist : model_->covariance(increment));
}

void WheelOdometry::saveState(ArchiveWriter& archive) const { archive(*this); }

void WheelOdometry::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::wheel_odometry
