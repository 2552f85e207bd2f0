// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/wheel_odometry/wheel_odometry.hpp"

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::wheel_odometry {
namespace {

const Registrar<OdometrySource, WheelOdometry> kRegistrar("wheel");
const SectionRegistrar<WheelOdometryConfig> kSectionRegistrar;

bool isFinite(const OdometrySample& sample) {
  return sample.twist.allFinite() && (!sample.pose || sample.pose->isFinite());
}

}  // namespace

void WheelOdometry::configure(const WheelOdometryConfig& config) {
  validate(config);
  config_ = config;
  model_ = makeMotionModel(config.motion_model, {config.alpha1, config.alpha2, config.alpha3,
                                                 config.alpha4, config.drive == "omnidirectional"});
  reset();
}

void WheelOdometry::configure(Settings& settings) {
  configure(settings.read<WheelOdometryConfig>());
}

void WheelOdometry::reset() {
  last_.reset();
  ahead_.reset();
  motion_.reset();
  odometry_pose_ = Pose2();
  next_sequence_ = 0;
  counters_.clear();
}

Status WheelOdometry::execute() {
  motion_.reset();
  if (!isFinite(input_)) return reject("invalid", "odometry holds a value that is not a number");
  if (last_ && input_.stamp <= last_->stamp - kStampJump) last_.reset();
  if (last_ && input_.stamp <= last_->stamp)
    return reject("late", "odometry is not newer than the message before it");
  if (isDoubtful(input_.stamp))
    return reject("stamp_jump",
                  "odometry is stamped far ahead of the message before it; it counts "
                  "once the next one is ahead as well");
  const bool same_frames = last_ && input_.odometry_frame == last_->odometry_frame &&
                           input_.base_frame == last_->base_frame;
  if (!same_frames) {
    const bool changed = last_.has_value();
    odometry_pose_ = input_.pose.value_or(Pose2());
    last_ = input_;
    if (!changed) return Status::ok();
    return reject("frame_change", "odometry frames changed to " + input_.odometry_frame + " -> " +
                                      input_.base_frame + "; the motion in between is lost");
  }

  Motion motion;
  motion.sequence = next_sequence_++;
  motion.start = last_->stamp;
  motion.end = input_.stamp;
  const Pose2 measured = incrementTo(input_);
  motion.increment = calibrated(measured);
  motion.covariance = covarianceOf(motion.increment, motion.end - motion.start);
  motion.odometry_start = odometry_pose_;
  motion.odometry_end = input_.pose.value_or(odometry_pose_ * measured);
  motion.odometry_frame = input_.odometry_frame;
  motion.base_frame = input_.base_frame;
  odometry_pose_ = motion.odometry_end;
  motion_ = motion;
  last_ = input_;
  return Status::ok();
}

bool WheelOdometry::isDoubtful(Stamp stamp) {
  const bool confirms = ahead_ && stamp > *ahead_;
  ahead_.reset();
  if (!last_ || confirms || stamp <= last_->stamp + kStampJump) return false;
  ahead_ = stamp;
  return true;
}

Status WheelOdometry::reject(const std::string& reason, const std::string& sentence) {
  counters_.add(reason);
  return Status::warning(sentence);
}

Pose2 WheelOdometry::incrementTo(const OdometrySample& sample) const {
  if (config_.increment == "pose" && sample.pose && last_->pose)
    return last_->pose->between(*sample.pose);
  return Pose2::exp(seconds(sample.stamp - last_->stamp) * last_->twist);
}

Pose2 WheelOdometry::calibrated(const Pose2& increment) const {
  if (config_.translation_scale == 1.0 && config_.rotation_scale == 1.0) return increment;
  Eigen::Vector3d twist = increment.log();
  twist.head<2>() *= config_.translation_scale;
  twist.z() *= config_.rotation_scale;
  return Pose2::exp(twist);
}

Eigen::Matrix3d WheelOdometry::covarianceOf(const Pose2& increment, Duration interval) const {
  const double dt = seconds(interval);
  const double position = config_.floor_position * config_.floor_position * dt;
  const double heading = config_.floor_heading * config_.floor_heading * dt;
  const Eigen::Matrix3d floor = Eigen::Vector3d(position, position, heading).asDiagonal();
  const bool given = config_.covariance == "twist" && isCovariance(last_->twist_covariance);
  return floor + (given ? dt * dt * last_->twist_covariance : model_->covariance(increment));
}

}  // namespace slam::wheel_odometry
