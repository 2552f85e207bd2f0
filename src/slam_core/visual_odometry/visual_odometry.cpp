// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_odometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/visual_odometry/drawing.hpp"

namespace slam::visual_odometry {
namespace {

const Registrar<OdometrySource, VisualOdometry> kRegistrar("visual");
const SectionRegistrar<VisualOdometryConfig> kSection;
const SectionRegistrar<CeilingCameraConfig> kCameraSection;

/// Random streams of other components have smaller numbers.
constexpr std::uint32_t kStream = 0xFFFF0001U;
constexpr double kWorthAWord = 0.35;  // of the camera's tilt [rad]
constexpr double kMaxTilt = 1.05;     // then hardly anything of the ceiling is seen [rad]

/// Covariance of a^-1 b where a and b have independent errors of that covariance.
Eigen::Matrix3d covarianceBetween(const Pose2& a, const Eigen::Matrix3d& C_a, const Pose2& b,
                                  const Eigen::Matrix3d& C_b) {
  Eigen::Matrix3d J_inverse, J_a, J_b;
  a.inverse(&J_inverse).compose(b, &J_a, &J_b);
  J_a *= J_inverse;
  return J_a * C_a * J_a.transpose() + J_b * C_b * J_b.transpose();
}

}  // namespace

void VisualOdometry::configure(const VisualOdometryConfig& config,
                               const CeilingCameraConfig& camera) {
  FaultCollector faults;
  faults.attempt([&] { validate(config); });
  faults.attempt([&] { config.requireHeight(); });
  faults.attempt([&] { gate_.configure(camera, CeilingCameraConfig::kSection); });
  faults.attempt([&] { policy_ = makeFeaturePolicy(config.features, config.max_features); });
  faults.raise();
  config_ = config;
  reset();
}

void VisualOdometry::configure(Settings& settings) {
  VisualOdometryConfig config;
  CeilingCameraConfig camera;
  FaultCollector faults;
  faults.attempt([&] { settings.read(config); });
  faults.attempt([&] { settings.read(camera); });
  faults.raise();
  configure(config, camera);
}

void VisualOdometry::reset() {
  gate_.reset();
  beginAnew();
  next_sequence_ = images_ = 0;
  motion_.reset();
  counters_.clear();
}

void VisualOdometry::beginAnew() {
  keyframe_.reset();
  last_.reset();
  last_good_.reset();
  alignment_ = {};
  matches_.clear();
  features_ = 0;
  gap_begin_.reset();
  velocity_.setZero();
  gap_covariance_.setZero();
}

Status VisualOdometry::execute() {
  motion_.reset();
  const auto status = gate_.next(counters_);
  if (!gate_.image()) return status;
  View now{gate_.image()->stamp, nullptr, last_ ? last_->T_odom_base : Pose2()};
  if (last_ && now.stamp <= last_->stamp) beginAnew();
  if (!gap_begin_) gap_begin_ = now.stamp;

  const auto fault = look(now);
  if (last_ && fault.empty() && keyframe_)
    follow(now);
  else if (last_)
    bridge(now);
  chooseKeyframe(now, fault.empty());
  last_ = std::move(now);
  return explain(fault, status);
}

/// Empty, or why the image tells nothing.
std::string VisualOdometry::look(View& now) {
  alignment_ = {};
  matches_.clear();
  features_ = 0;
  ++images_;
  if (!gate_.isUsable()) return "unusable";  // counted by the gate
  view_ = CeilingView(gate_.camera(), gate_.mount().T_base_camera, config_.ceiling_height);
  auto fault = view_.tilt() > kMaxTilt ? std::string("camera_direction") : locate(now);
  if (fault.empty()) return fault;
  counters_.add(fault);
  return fault;
}

std::string VisualOdometry::locate(View& now) {
  auto features = policy_->extract(gate_.image()->gray, view_);
  features_ = features.size();
  now.features = std::make_shared<const Features>(std::move(features));
  if (policy_->countsFeatures() && features_ < static_cast<std::size_t>(config_.min_inliers))
    return "few_features";
  if (!keyframe_ || alignWith(*keyframe_, now)) return "";
  const auto fault = alignment_.fault;
  if (last_good_->stamp == keyframe_->stamp) return fault;
  // by now too little of the keyframe may be in sight
  auto reference = *last_good_;
  prepare(reference);
  if (!alignWith(reference, now)) return fault;
  keyframe_ = std::move(reference);
  keyframe_inliers_ = 0;
  counters_.add("keyframes");
  return "";
}

bool VisualOdometry::alignWith(const View& reference, View& now) {
  matches_ =
      policy_->match(*reference.features, *now.features, view_, windowFor(reference, now.stamp));
  RandomStream random(seed_, images_, kStream);
  alignment_ = align(matches_, config_, random);
  alignment_.covariance *= policy_->dependence();
  if (!alignment_.fault.empty()) {
    return false;
  }
  now.T_odom_base = reference.T_odom_base * alignment_.T_reference_now;
  T_odom_reference_ = reference.T_odom_base;
  if (!isWithinReach(now)) alignment_.fault = "speed";
  return alignment_.fault.empty();
}

SearchWindow VisualOdometry::windowFor(const View& reference, Stamp stamp) const {
  const double dt = seconds(stamp - last_good_->stamp);
  const Pose2 expected = last_good_->T_odom_base * Pose2::exp(dt * velocity_);
  return {reference.T_odom_base.between(expected), dt * config_.max_speed,
          std::min(dt * config_.max_turn_rate, M_PI)};
}

bool VisualOdometry::isWithinReach(const View& now) const {
  const double dt = seconds(now.stamp - last_good_->stamp);
  const Pose2 step = last_good_->T_odom_base.between(now.T_odom_base);
  // what noise alone may seem to move
  const double noise = 3.0 * std::sqrt(alignment_.covariance.diagonal().head<2>().maxCoeff());
  const double turn_noise = 3.0 * std::sqrt(alignment_.covariance(2, 2));
  return step.position().norm() <= dt * config_.max_speed + noise &&
         std::abs(step.theta()) <= dt * config_.max_turn_rate + turn_noise;
}

void VisualOdometry::follow(const View& now) {
  publish(now, covarianceOf(now) + gap_covariance_);
  gap_covariance_.setZero();
  if (last_->stamp != last_good_->stamp) return;  // the step out of a gap is no velocity
  velocity_ = motion_->increment.log() / seconds(now.stamp - last_->stamp);
}

void VisualOdometry::bridge(View& now) {
  auto gap = gap_source_ ? gap_source_(last_->stamp, now.stamp) : std::nullopt;
  if (!gap) gap = coast(last_->stamp, now.stamp);
  now.T_odom_base = last_->T_odom_base * gap->increment;
  gap_covariance_ += gap->covariance;
  publish(now, gap->covariance);
}

/// The last velocity may be wrong for as long as the gap lasts, so that its error adds up: the
/// standard deviations of the increments come to max_speed times the gap's length, however many
/// images are in it.
GapMotion VisualOdometry::coast(Stamp start, Stamp end) const {
  const double before = seconds(start - *gap_begin_), after = seconds(end - *gap_begin_);
  const double growth = after * after - before * before;  // [s^2]
  const double way2 = growth * config_.max_speed * config_.max_speed;
  const double turn2 = growth * config_.max_turn_rate * config_.max_turn_rate;
  GapMotion gap;
  gap.increment = Pose2::exp((after - before) * velocity_);
  gap.covariance.diagonal() << way2, way2, std::min(turn2, M_PI * M_PI);
  return gap;
}

/// Of the increment to an image that was aligned. The reference's errors are common to this image
/// and the one before, so that they nearly cancel: what remains are the images' own, half of the
/// alignment's each.
Eigen::Matrix3d VisualOdometry::covarianceOf(const View& now) const {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = T_odom_reference_.rotation();
  const Eigen::Matrix3d own = 0.5 * R * alignment_.covariance * R.transpose();
  Eigen::Matrix3d Q = covarianceBetween(last_->T_odom_base, own, now.T_odom_base, own);
  const double dt = seconds(now.stamp - last_->stamp);
  const double way = (now.T_odom_base.position() - last_->T_odom_base.position()).norm();
  const double position =
      config_.alpha_translation * way + config_.floor_position * config_.floor_position * dt;
  const double heading =
      config_.alpha_rotation * way + config_.floor_heading * config_.floor_heading * dt;
  Q.diagonal() += Eigen::Vector3d(position, position, heading);
  return Q;
}

void VisualOdometry::publish(const View& now, const Eigen::Matrix3d& covariance) {
  Motion motion;
  motion.sequence = next_sequence_++;
  motion.start = last_->stamp;
  motion.end = now.stamp;
  motion.increment = last_->T_odom_base.between(now.T_odom_base);
  motion.covariance = 0.5 * (covariance + covariance.transpose());
  motion.odometry_start = last_->T_odom_base;
  motion.odometry_end = now.T_odom_base;
  motion_ = motion;
}

void VisualOdometry::chooseKeyframe(const View& now, bool is_good) {
  if (!is_good) {
    // the robot may have left what the keyframe shows
    const bool is_patient = seconds(now.stamp - *gap_begin_) < config_.patience;
    if (keyframe_ && now.features && !is_patient) makeKeyframe(now);
    return;
  }
  if (!keyframe_) return makeKeyframe(now);
  last_good_ = now;
  gap_begin_ = now.stamp;
  const auto inliers = alignment_.inliers.size();
  keyframe_inliers_ = std::max(keyframe_inliers_, inliers);
  if (static_cast<double>(inliers) <
      config_.keyframe_share * static_cast<double>(keyframe_inliers_))
    makeKeyframe(now);
}

/// From here on the pose is told in relation to this view.
void VisualOdometry::makeKeyframe(View view) {
  prepare(view);
  if (view.features->size() < static_cast<std::size_t>(config_.min_inliers)) return;
  keyframe_ = view;
  last_good_ = std::move(view);
  gap_begin_ = last_good_->stamp;
  gap_covariance_.setZero();
  keyframe_inliers_ = 0;
  counters_.add("keyframes");
}

void VisualOdometry::prepare(View& view) const {
  auto features = *view.features;
  policy_->prepareReference(features, view_);
  view.features = std::make_shared<const Features>(std::move(features));
}

Status VisualOdometry::explain(const std::string& fault, const Status& gate_status) const {
  if (!gate_status.isOk()) return gate_status;
  if (fault.empty() && view_.tilt() > kWorthAWord)
    return Status::warning(
        fmt::format("the ceiling camera does not look up: its mount says that it is tilted by "
                    "{:.0f} deg; correct its transform to the robot's base frame",
                    view_.tilt() * 180.0 / M_PI));
  if (fault.empty()) return Status::ok();
  return Status::warning(sentenceOf(fault) + (gap_source_
                                                  ? "; the wheels' motion is used meanwhile"
                                                  : "; the last velocity is used meanwhile"));
}

std::string VisualOdometry::sentenceOf(const std::string& fault) const {
  if (fault == "few_features")
    return fmt::format(
        "the ceiling shows only {} features, {} are needed: it is dark, blurred or "
        "bare",
        features_, config_.min_inliers);
  if (fault == "scale")
    return fmt::format("the ceiling seems {:.2f} times as far as before: another surface is seen",
                       alignment_.scale);
  if (fault == "speed") return "the images tell of a motion that max_speed or max_turn_rate forbid";
  if (fault == "camera_direction")
    return fmt::format(
        "the ceiling camera does not look up: its mount says that it is tilted by "
        "{:.0f} deg; correct its transform to the robot's base frame",
        view_.tilt() * 180.0 / M_PI);
  return fmt::format("only {} of {} matches agree on one motion of the ceiling, {} are needed",
                     alignment_.inliers.size(), matches_.size(), config_.min_inliers);
}

cv::Mat VisualOdometry::drawing() const {
  return gate_.image() ? draw(gate_.image()->gray, matches_, alignment_.inliers) : cv::Mat();
}

std::vector<std::pair<std::string, double>> VisualOdometry::figures() const {
  return {{"features", static_cast<double>(features_)},
          {"matches", static_cast<double>(matches_.size())},
          {"inliers", static_cast<double>(alignment_.inliers.size())},
          {"scale", alignment_.scale},
          {"keyframes", static_cast<double>(counters_["keyframes"])}};
}

}  // namespace slam::visual_odometry
