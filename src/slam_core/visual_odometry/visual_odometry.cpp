// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_odometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/visual_odometry/drawing.hpp"

namespace slam::visual_odometry {
namespace {

const Registrar<OdometrySource, VisualOdometry> kRegistrar("visual");
const SectionRegistrar<VisualOdometryConfig> kSection;

constexpr double kWorthAWord = 0.35;  // of the camera's tilt [rad]

}  // namespace

void VisualOdometry::configure(const VisualOdometryConfig& config) {
  FaultCollector faults;
  faults.attempt([&] { validate(config); });
  faults.attempt([&] { config.requireHeight(); });
  faults.attempt([&] { matcher_.configure(config); });
  faults.raise();
  config_ = config;
  increments_.configure(config);
  reset();
}

void VisualOdometry::configure(Settings& settings) {
  VisualOdometryConfig config;
  CeilingCameraConfig camera;
  FaultCollector faults;
  faults.attempt([&] { config = settings.read<VisualOdometryConfig>(); });
  faults.attempt([&] { camera = settings.read<CeilingCameraConfig>(); });
  faults.raise();
  if (config.ceiling_height == 0.0) config.ceiling_height = camera.ceiling_height;
  configure(config);
}

void VisualOdometry::describe(Ports& ports) {
  ports.takes<CameraView>(CeilingCameraConfig::kSection, "images of the ceiling", this);
  ports.makes<Motion>("motion", motion_);
}

void VisualOdometry::reset() {
  next_view_.reset();
  view_.reset();
  matcher_.reset();
  views_ = {};
  increments_.reset();
  motion_.reset();
  counters_.clear();
}

void VisualOdometry::beginAnew() {
  views_ = {};
  increments_.beginAnew();
}

Status VisualOdometry::execute() {
  motion_.reset();
  is_measured_ = false;
  view_ = std::exchange(next_view_, std::nullopt);
  if (!view_) return Status::ok();
  auto& last = views_.last;
  View now{view_->stamp, nullptr, last ? last->T_odom_base : Pose2()};
  if (last && now.stamp <= last->stamp) beginAnew();
  if (!views_.gap_begin) views_.gap_begin = now.stamp;

  auto fault = look(now);
  if (last && fault.empty() && views_.keyframe) {
    is_measured_ = last->stamp == views_.last_good->stamp;
    motion_ = increments_.follow(*last, now, matcher_.alignment(), views_.T_odom_reference,
                                 !is_measured_);
  } else if (last)
    motion_ = increments_.bridge(*last, now, *views_.gap_begin);
  if (!chooseKeyframe(now, fault.empty())) counters_.add(fault = "few_features");
  last = std::move(now);
  return explain(fault);
}

/// An image that comes again is one of a camera that hangs, or stands still without noise: the
/// wheels know which. Where there are none, it stands still.
bool VisualOdometry::tells(const CameraView& view) const {
  return view.isUsable() || (view.is_repeated && !increments_.hasGapSource());
}

/// Empty, or why the image tells nothing.
std::string VisualOdometry::look(View& now) {
  matcher_.beginImage();
  if (!tells(*view_)) return "unusable";  // its gate has said why
  auto fault = matcher_.take(*view_, now);
  if (fault.empty()) fault = locate(now);
  if (!fault.empty()) counters_.add(fault);
  return fault;
}

std::string VisualOdometry::locate(View& now) {
  if (!views_.keyframe) return "";
  const auto fault = alignWith(*views_.keyframe, now);
  if (fault.empty() || views_.last_good->stamp == views_.keyframe->stamp) return fault;
  // by now too little of the keyframe may be in sight
  auto reference = *views_.last_good;
  matcher_.prepare(reference);
  if (!alignWith(reference, now).empty()) return fault;
  views_.keyframe = std::move(reference);
  views_.keyframe_inliers = 0;
  counters_.add("keyframes");
  return "";
}

/// Empty, or why the two do not fit.
std::string VisualOdometry::alignWith(const View& reference, View& now) {
  const auto& alignment = matcher_.align(reference, now, windowFor(reference, now.stamp));
  if (!alignment.fault.empty()) return alignment.fault;
  now.T_odom_base = reference.T_odom_base * alignment.T_reference_now;
  views_.T_odom_reference = reference.T_odom_base;
  return isWithinReach(now) ? "" : "speed";
}

SearchWindow VisualOdometry::windowFor(const View& reference, Stamp stamp) const {
  const double dt = seconds(stamp - views_.last_good->stamp);
  const Pose2 expected = increments_.expected(*views_.last_good, stamp);
  return {reference.T_odom_base.between(expected), dt * config_.max_speed,
          std::min(dt * config_.max_turn_rate, M_PI)};
}

bool VisualOdometry::isWithinReach(const View& now) const {
  const double dt = seconds(now.stamp - views_.last_good->stamp);
  const Pose2 step = views_.last_good->T_odom_base.between(now.T_odom_base);
  // what noise alone may seem to move
  const auto& covariance = matcher_.alignment().covariance;
  const double noise = 3.0 * std::sqrt(covariance.diagonal().head<2>().maxCoeff());
  const double turn_noise = 3.0 * std::sqrt(covariance(2, 2));
  return step.position().norm() <= dt * config_.max_speed + noise &&
         std::abs(step.theta()) <= dt * config_.max_turn_rate + turn_noise;
}

/// Whether there is one in the end, unless another fault of the image is known.
bool VisualOdometry::chooseKeyframe(const View& now, bool is_good) {
  if (!is_good) {
    // the robot may have left what the keyframe shows
    const bool is_patient = seconds(now.stamp - *views_.gap_begin) < config_.patience;
    if (views_.keyframe && now.features && !is_patient) makeKeyframe(now);
    return true;
  }
  if (!views_.keyframe) return makeKeyframe(now);
  views_.last_good = now;
  views_.gap_begin = now.stamp;
  const auto inliers = matcher_.alignment().inliers.size();
  views_.keyframe_inliers = std::max(views_.keyframe_inliers, inliers);
  if (static_cast<double>(inliers) <
      config_.keyframe_share * static_cast<double>(views_.keyframe_inliers))
    makeKeyframe(now);  // or the old one serves on
  return true;
}

/// From here on the pose is reported relative to this view. Not where it has too few features.
bool VisualOdometry::makeKeyframe(View view) {
  matcher_.prepare(view);
  if (view.features->size() < static_cast<std::size_t>(config_.min_inliers)) return false;
  views_.keyframe = view;
  views_.last_good = std::move(view);
  views_.gap_begin = views_.last_good->stamp;
  increments_.forgetGap();
  views_.keyframe_inliers = 0;
  counters_.add("keyframes");
  return true;
}

Status VisualOdometry::explain(const std::string& fault) const {
  if (!tells(*view_)) return Status::ok();
  if (fault.empty() && matcher_.ceiling().tilt() > kWorthAWord)
    return Status::warning(sentenceOf("camera_direction"));
  if (fault.empty()) return Status::ok();
  return Status::warning(sentenceOf(fault) + "; " + increments_.instead());
}

std::string VisualOdometry::sentenceOf(const std::string& fault) const {
  if (fault == "few_features")
    return fmt::format(
        "the ceiling shows only {} features, {} are needed: it is dark, blurred or "
        "bare",
        matcher_.features(), config_.min_inliers);
  if (fault == "scale")
    return fmt::format("the ceiling seems {:.2f} times as far as before: another surface is seen",
                       matcher_.alignment().scale);
  if (fault == "speed") return "the images tell of a motion that max_speed or max_turn_rate forbid";
  if (fault == "camera_direction")
    return fmt::format(
        "the ceiling camera does not look up: its mount says that it is tilted by "
        "{:.0f} deg; correct its transform to the robot's base frame",
        matcher_.ceiling().tilt() * 180.0 / M_PI);
  return fmt::format("only {} of {} matches agree on one motion of the ceiling, {} are needed",
                     matcher_.alignment().inliers.size(), matcher_.matches().size(),
                     config_.min_inliers);
}

cv::Mat VisualOdometry::drawing() const {
  return view_ ? draw(view_->image.gray, matcher_.matches(), matcher_.alignment().inliers)
               : cv::Mat();
}

Component::Figures VisualOdometry::figures() const {
  return {{"features", static_cast<double>(matcher_.features())},
          {"matches", static_cast<double>(matcher_.matches().size())},
          {"inliers", static_cast<double>(matcher_.alignment().inliers.size())},
          {"scale", matcher_.alignment().scale},
          {"keyframes", static_cast<double>(counters_["keyframes"])}};
}

void VisualOdometry::saveState(ArchiveWriter& archive) const { archive(*this); }

void VisualOdometry::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::visual_odometry
