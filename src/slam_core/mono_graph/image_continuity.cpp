// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/image_continuity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "slam_core/models/independence.hpp"

namespace slam::mono_graph {
namespace {

/// The robot is lost when the images of another scene have this weight.
constexpr double kLost = 2.0;
constexpr Independence kScenes{0.15, 0.2};
/// A robot that has moved and turned no more than this sees much of the same [m], [rad].
constexpr double kSameViewWay = 0.6, kSameViewTurn = 0.5;
constexpr double kNearestDepth = 1.0, kFarthestDepth = 50.0;  ///< of what a camera sees [m]
constexpr std::size_t kMostCompared = 100;                    ///< features, the strongest ones
constexpr std::size_t kFewestCompared = 20;
/// An image shows at least this share of the features of the one before; two scenes have a
/// hundredth in common.
constexpr double kSameScene = 0.1;
constexpr double kSearchRadius = 10.0;  ///< around where a feature is predicted [px]
constexpr double kHeadingSigmas = 3.0;
constexpr int kLargestDistance = 60;  ///< of descriptors
constexpr double kDistinct = 0.85;    ///< of the best one's distance to the second one's
constexpr int kLevelsApart = 1;

/// A feature may be seen again within this distance of a point. Each depth puts it elsewhere along
/// a line.
struct Reach {
  Eigen::Vector2d middle;
  double radius = 0.0;  ///< [px]
};

/// Nothing where it may be out of view.
std::optional<Reach> reachOf(const Features& earlier, const Feature& feature,
                             const Features& features, const OdometryAnchor& odometry) {
  const Eigen::Vector3d ray = earlier.camera().ray({}, feature.seen);
  const Eigen::Vector3d centre = earlier.camera().centre({});
  const auto far = features.camera().project(odometry.since(), centre + kFarthestDepth * ray);
  const auto near = features.camera().project(odometry.since(), centre + kNearestDepth * ray);
  if (!far || !near || !features.covers(*far) || !features.covers(*near)) return std::nullopt;
  const double heading = kHeadingSigmas * std::sqrt(odometry.covarianceSince()(2, 2));
  const double length = (*far - *near).norm();
  return Reach{0.5 * (*far + *near), kSearchRadius + features.focal() * (0.5 * length + heading)};
}

bool isSeenAgain(const Feature& feature, const Features& features,
                 const std::vector<std::size_t>& near) {
  int best = std::numeric_limits<int>::max(), second = best;
  for (const std::size_t i : near) {
    const auto& other = features[i];
    if (std::abs(other.level - feature.level) > kLevelsApart ||
        turnBetween(other.angle, feature.angle) > kLargestRoll)
      continue;
    const int distance = distanceOf(other.descriptor, feature.descriptor);
    second = std::min(second, std::max(best, distance));
    best = std::min(best, distance);
  }
  return best <= kLargestDistance && best <= kDistinct * second;
}

bool isSameView(const OdometryAnchor& odometry) {
  const Pose2& since = odometry.since();
  return since.position().norm() <= kSameViewWay && std::abs(since.theta()) <= kSameViewTurn;
}

}  // namespace

void ImageContinuity::move(const Motion& motion) {
  for (auto* const image : {&earlier_, &last_})
    if (*image) (*image)->odometry.move(motion);
}

/// Nothing is known of an image of another camera, nor of one that has few features: it may be
/// blurred or dark.
ImageContinuity::Same ImageContinuity::compared(const Image& earlier, const Features& features) {
  if (features.focal() != earlier.features.focal() || features.size() < kMostCompared)
    return Same::kUnknown;
  std::size_t expected = 0, found = 0;
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < earlier.features.size() && expected < kMostCompared; ++i) {
    const auto& feature = earlier.features[i];
    const auto reach = reachOf(earlier.features, feature, features, earlier.odometry);
    if (!reach) continue;
    near.clear();
    features.near(reach->middle, reach->radius, near);
    ++expected;
    if (isSeenAgain(feature, features, near)) ++found;
  }
  if (expected < kFewestCompared) return Same::kUnknown;
  return static_cast<double>(found) < kSameScene * static_cast<double>(expected) ? Same::kNo
                                                                                 : Same::kYes;
}

void ImageContinuity::judge(const Features& features, Stamp stamp) {
  if (!earlier_ || !isSameView(earlier_->odometry)) return begin(features, false);
  switch (compared(*earlier_, features)) {
    case Same::kYes:
      return begin(features, true);
    case Same::kNo:
      return is_scene_ ? contradict(features, stamp) : begin(features, false);
    case Same::kUnknown:
      last_ = Image{features, {}};
  }
}

/// Later images are compared with this one.
void ImageContinuity::begin(const Features& features, bool is_scene) {
  earlier_ = Image{features, {}};
  is_scene_ = is_scene;
  last_.reset();
  broken_since_.reset();
  broken_ = 0.0;
}

void ImageContinuity::contradict(const Features& features, Stamp stamp) {
  if (!broken_since_) broken_since_ = stamp;
  if (last_ && compared(*last_, features) == Same::kYes)
    broken_ += kScenes.weightOf(last_->odometry.since(), {});
  if (broken_ >= kLost && !lost_since_) lost_since_ = broken_since_;
  last_ = Image{features, {}};
}

void ImageContinuity::settle() { *this = {}; }

}  // namespace slam::mono_graph
