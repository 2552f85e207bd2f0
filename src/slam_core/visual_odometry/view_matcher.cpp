// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/view_matcher.hpp"

#include <utility>

#include "slam_core/common/random.hpp"

namespace slam::visual_odometry {
namespace {

/// Random streams of other components have smaller numbers.
constexpr std::uint32_t kStream = 0xFFFF0001U;
constexpr double kMaxTilt = 1.05;  // then hardly anything of the ceiling is seen [rad]

}  // namespace

void ViewMatcher::configure(const VisualOdometryConfig& config) {
  policy_ = makeFeaturePolicy(config.features, config.max_features);
  config_ = config;
  reset();
}

void ViewMatcher::reset() {
  images_ = 0;
  alignment_ = {};
  matches_.clear();
  features_ = 0;
}

void ViewMatcher::beginImage() {
  alignment_ = {};
  matches_.clear();
  features_ = 0;
  ++images_;
}

std::string ViewMatcher::take(const CameraView& view, View& now) {
  ceiling_ = CeilingView(*view.camera, view.mount.T_base_camera, config_.ceiling_height);
  if (ceiling_.tilt() > kMaxTilt) return "camera_direction";
  auto features = policy_->extract(view.image.gray, ceiling_);
  features_ = features.size();
  now.features = std::make_shared<const Features>(std::move(features));
  const bool are_few = features_ < static_cast<std::size_t>(config_.min_inliers);
  return policy_->countsFeatures() && are_few ? "few_features" : "";
}

const Alignment& ViewMatcher::align(const View& reference, const View& now,
                                    const SearchWindow& window) {
  countTracked(*reference.features);
  matches_ = policy_->match(*reference.features, *now.features, ceiling_, window);
  RandomStream random(seed_, images_, kStream);
  alignment_ = visual_odometry::align(matches_, config_, random);
  alignment_.covariance *= policy_->dependence();
  return alignment_;
}

void ViewMatcher::countTracked(const Features& reference) {
  if (!policy_->countsFeatures()) features_ = reference.size();
}

void ViewMatcher::prepare(View& view) {
  auto features = *view.features;
  policy_->prepareReference(features, ceiling_);
  countTracked(features);
  view.features = std::make_shared<const Features>(std::move(features));
}

}  // namespace slam::visual_odometry
