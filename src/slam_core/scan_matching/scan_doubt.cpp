// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_doubt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam_core/models/independence.hpp"

namespace slam::scan_matching {
namespace {

/// In wrong places a third of a scan contradicts the map in the mean, and anything may.
constexpr ShareDistribution kLost{1.5, 3.0};
/// Now and then a scan that has nothing to do with the map is taken in the right place, once in
/// e^this scans: no single scan says more.
constexpr double kMostOfAScan = 6.0;
/// A wide search finds a robot that was carried in one case of two, and something in one of 800
/// scans else: the logarithm of this ratio is ln(0.5 * 800) = 6.
constexpr double kOfAJump = 6.0;
/// A place that a loaded map does not show is less usual than a wrong pose.
constexpr double kOfNothingKnown = 1.0;
/// People walk on in the time.
constexpr Independence kScans{0.4, 0.6, 4.0};
/// Relative to the threshold: up to this the robot counts as right, and its scans are learnt from.
constexpr double kRight = 0.4;
/// Relative to the threshold: from here on scans that speak for a wrong place stay out of the map.
constexpr double kDoubtful = 0.75;
/// Relative to the threshold: more is not summed up, so that an alarm ends once the robot is right
/// again.
constexpr double kMost = 2.0;

}  // namespace

ScanDoubt::ScanDoubt(double lost_share, double false_alarm_hours, bool map_is_fixed)
    : lost_share_(lost_share), map_is_fixed_(map_is_fixed) {
  constexpr double kScansInAnHour = 3600.0;  // independent ones of a robot under way: one a second
  threshold_ = std::log(kScansInAnHour * false_alarm_hours);
}

void ScanDoubt::judge(const Match& match, Stamp stamp) {
  const double weight = weightOf(match.pose, stamp);
  agreement_ = match.agreement;
  is_determined_ = match.is_determined;
  jumped_ = match.jumped;
  is_anywhere_ = match.is_anywhere;
  evidence_ = is_anywhere_ ? kMostOfAScan : evidenceOf(match);
  if (is_anywhere_)
    beLost(stamp);
  else
    add(weight * evidence_ + (jumped_ ? kOfAJump : 0.0), stamp);
  if (statistic() < kRight) usual_.learn(agreement_, weight);
  pose_ = match.pose;
  stamp_ = stamp;
}

/// Every scan fits somewhere at the edge of a map, where few of its ends lie in known cells. A
/// search for the lost robot may have led there, so such a scan is no evidence that it is right.
double ScanDoubt::evidenceOf(const Match& match) const {
  const auto& seen = match.agreement;
  double ratio = kLost.logLikelihood(seen) - usual_.distribution().logLikelihood(seen);
  const bool is_beside = seen.silent > seen.known();
  if (isLost() && is_beside) ratio = std::max(ratio, 0.0);
  const bool is_beside_map = map_is_fixed_ && !match.is_determined && is_beside;
  return std::clamp(ratio, is_beside_map ? kOfNothingKnown : -kMostOfAScan, kMostOfAScan);
}

double ScanDoubt::weightOf(const Pose2& pose, Stamp stamp) const {
  return pose_ ? kScans.weightOf(pose_->between(pose), stamp - stamp_) : 1.0;
}

void ScanDoubt::add(double evidence, Stamp stamp) {
  if (sum_ == 0.0) began_ = stamp;
  sum_ = std::clamp(sum_ + evidence, 0.0, kMost * threshold_);
  if (sum_ == 0.0) lost_since_.reset();
  if (sum_ >= threshold_ && !lost_since_) lost_since_ = began_;
}

void ScanDoubt::beLost(Stamp stamp) {
  add(evidence_, stamp);
  sum_ = std::max(sum_, threshold_);
  if (!lost_since_) lost_since_ = stamp;
}

bool ScanDoubt::admits() const {
  if (agreement_.contradictingShare() > lost_share_) return false;
  return !isLost() && (statistic() < kDoubtful || evidence_ <= 0.0);
}

Status ScanDoubt::status() const {
  constexpr double kDegrees = 180.0 / M_PI;
  if (lost_since_ && is_anywhere_)
    return Status::alarm(
        "the robot is lost: motion was missing for so long that it may be anywhere around; drive "
        "on where the robot has been, or set an initial pose");
  if (lost_since_)
    return Status::alarm(
        fmt::format("scans have not fitted the map since {:.1f} s: the pose may be lost, or the "
                    "map is wrong; set an initial pose or load another map",
                    1e-9 * static_cast<double>(nanoseconds(*lost_since_))));
  if (jumped_)
    return Status::warning(fmt::format(
        "a scan was found {:.1f} m and {:.0f} degrees from where motion led: the robot was carried "
        "or its wheels slipped; check the pose, and set an initial pose where it is wrong",
        jumped_->position().norm(), kDegrees * std::abs(jumped_->theta())));
  return Status::ok();
}

void ScanDoubt::forget() {
  usual_ = {};
  sum_ = evidence_ = 0.0;
  lost_since_.reset();
  pose_.reset();
  jumped_.reset();
  is_anywhere_ = false;
  is_determined_ = false;
  agreement_ = {};
}

}  // namespace slam::scan_matching
