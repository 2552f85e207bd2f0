// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/tracking_doubt.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/models/beta_distribution.hpp"
#include "slam_core/models/independence.hpp"

namespace slam {
namespace {

/// In a wrong place a sixth of the features is found by chance in the mean, where patterns repeat
/// many more.
constexpr BetaDistribution kLostShare{0.7, 3.5};
/// The share of a robot that is right, before anything is learnt.
constexpr double kFirstMean = 0.7, kFirstDeviation = 0.2;
/// It is learnt within these bounds: an image with less is none to learn from as it stands.
constexpr double kLeastShown = 0.3, kMostMean = 0.95, kLeastShownDeviation = 0.08;
constexpr double kLeastSureness = 4.0, kMostSureness = 60.0;
constexpr double kImagesRemembered = 20.0;  ///< independent ones
/// Fewer features say nothing. More are no more independent: they are hidden and blurred together.
constexpr double kFewestFeatures = 4.0, kMostFeatures = 20.0;
/// Once in e^this images something hides the whole view: no single image says more.
constexpr double kMostOfAnImage = 6.0;
/// A feature may have gone, and is missing in each image then: it adds no more to one doubt.
constexpr double kMostOfOne = 1.25;
/// Where nothing is expected, a doubt fades.
constexpr double kOfNothingInView = 0.3;
/// Whatever hid the view has moved in the time.
constexpr Independence kImages{0.2, 0.3, 0.4};
/// Relative to the threshold: up to this the robot counts as right, and its images are learnt from.
constexpr double kStillRight = 0.2;
/// Relative to the threshold and to what an image may say: from here on those that speak for a
/// wrong place stay out of the map.
constexpr double kInDoubt = 0.4, kByItself = 0.5;

}  // namespace

TrackingDoubt::TrackingDoubt(double false_alarm_hours)
    : mean_(kFirstMean), variance_(kFirstDeviation * kFirstDeviation) {
  constexpr double kImagesInAnHour = 3600.0 / kImages.time;
  threshold_ = std::log(kImagesInAnHour * false_alarm_hours);
}

void TrackingDoubt::judge(const ViewOfMap& view, const Pose2& pose, Stamp stamp) {
  const double weight = weightOf(pose, stamp);
  const bool shows = static_cast<double>(view.expected) >= kFewestFeatures;
  evidence_ = shows ? evidenceOf(view) : 0.0;
  if (sum_ == 0.0) {
    began_ = stamp;
    most_expected_ = 0.0;
  }
  most_expected_ = std::max(most_expected_, static_cast<double>(view.expected));
  const double most = std::max(sum_, kMostOfOne * most_expected_);
  sum_ = std::clamp(sum_ + weight * (shows ? evidence_ : -kOfNothingInView), 0.0, most);
  if (sum_ >= threshold_ && !lost_since_) lost_since_ = began_;
  if (shows && sum_ < kStillRight * threshold_)
    learn(static_cast<double>(view.found) / static_cast<double>(view.expected), weight);
  pose_ = pose;
  stamp_ = stamp;
}

double TrackingDoubt::evidenceOf(const ViewOfMap& view) const {
  const auto right = BetaDistribution::ofMoments(view.in_reach * std::min(mean_, kMostMean),
                                                 variance_, kLeastSureness, kMostSureness);
  const auto expected = static_cast<double>(view.expected);
  const double count = std::min(expected, kMostFeatures);
  const double found = count * static_cast<double>(view.found) / expected;
  const double ratio =
      kLostShare.logLikelihood(found, count - found) - right.logLikelihood(found, count - found);
  return std::clamp(ratio, -kMostOfAnImage, kMostOfAnImage);
}

double TrackingDoubt::weightOf(const Pose2& pose, Stamp stamp) const {
  return pose_ ? kImages.weightOf(pose_->between(pose), stamp - stamp_) : 1.0;
}

void TrackingDoubt::learn(double share, double weight) {
  const double off = std::max(kLeastShown, share) - mean_;
  const double gain = weight / kImagesRemembered;
  variance_ = std::max(variance_ + gain * (off * off - variance_),
                       kLeastShownDeviation * kLeastShownDeviation);
  mean_ += gain * off;
}

std::optional<Stamp> TrackingDoubt::doubtedSince() const {
  return sum_ > 0.0 ? std::optional(began_) : std::nullopt;
}

bool TrackingDoubt::admits() const {
  return !isLost() && (evidence_ <= 0.0 ||
                       (sum_ < kInDoubt * threshold_ && evidence_ < kByItself * kMostOfAnImage));
}

/// What is usual there is learnt anew.
void TrackingDoubt::settle() {
  mean_ = kFirstMean;
  variance_ = kFirstDeviation * kFirstDeviation;
  sum_ = evidence_ = 0.0;
  lost_since_.reset();
  pose_.reset();
}

}  // namespace slam
