// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/image_continuity.hpp"

#include <cmath>
#include <optional>

#include "slam_core/models/independence.hpp"
#include "slam_core/mono_graph/two_views.hpp"

namespace slam::mono_graph {
namespace {

/// The robot is lost when the images of another scene have this weight.
constexpr double kLost = 2.0;
constexpr Independence kScenes{0.15, 0.2};
/// A robot that has moved and turned no more than this sees much of the same [m], [rad].
constexpr double kSameViewWay = 0.6, kSameViewTurn = 0.5;
constexpr std::size_t kMostCompared = 100;  ///< features, the strongest ones
constexpr std::size_t kFewestCompared = 20;
/// An image shows at least this share of the features of the one before; two scenes have a
/// hundredth in common.
constexpr double kSameScene = 0.1;

bool isSameView(const OdometryAnchor& odometry) {
  const Pose2 since = odometry.since().pose;
  return since.position().norm() <= kSameViewWay && std::abs(since.theta()) <= kSameViewTurn;
}

}  // namespace

void ImageContinuity::move(const Motion& motion) {
  for (auto* const image : {&earlier_, &last_})
    if (*image) (*image)->odometry.move(motion);
}

/// Nothing is known of an image of another camera.
ImageContinuity::Same ImageContinuity::compared(const Image& earlier, const Features& features) {
  if (features.focal() != earlier.features.focal()) return Same::kUnknown;
  const auto again =
      pairFeatures(earlier.features, features, earlier.odometry.since(), kMostCompared);
  if (again.expected < kFewestCompared) return Same::kUnknown;
  const double share =
      static_cast<double>(again.pairs.size()) / static_cast<double>(again.expected);
  return share < kSameScene ? Same::kNo : Same::kYes;
}

/// An image with far fewer features is blurred or dark, and says nothing, unless it shows what the
/// image before it showed: a bare scene moves on as the robot does.
void ImageContinuity::judge(const Features& features, Stamp stamp) {
  if (!earlier_ || !isSameView(earlier_->odometry)) return begin(features, false);
  if (2 * features.size() < earlier_->features.size() &&
      (!last_ || compared(*last_, features) != Same::kYes)) {
    last_ = Image{features, {}};
    return;
  }
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
    broken_ += kScenes.weightOf(last_->odometry.since().pose, {});
  if (broken_ >= kLost && !lost_since_) lost_since_ = broken_since_;
  last_ = Image{features, {}};
}

void ImageContinuity::settle() { *this = {}; }

}  // namespace slam::mono_graph
