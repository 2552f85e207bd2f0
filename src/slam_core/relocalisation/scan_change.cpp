// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/scan_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace slam::relocalisation {
namespace {

// Scans that are further apart are not compared.
constexpr double kFurthest = 1.0, kLargestTurn = 0.7;        // [m], [rad]
constexpr double kVaguePosition = 0.3, kVagueHeading = 0.1;  // sigma of the motion [m], [rad]
constexpr Duration kLongest = std::chrono::seconds(5);
constexpr int kInARow = 3;
constexpr Duration kShortestChange = std::chrono::milliseconds(300);
constexpr std::size_t kFewestHits = 20;
/// Wheels that slip turn the robot otherwise than odometry says [rad].
constexpr std::array<double, 5> kSlips = {0.0, 0.075, -0.075, 0.15, -0.15};

}  // namespace

void ScanChange::move(const Motion& motion) {
  for (auto* scan : {&last_, &unlike_})
    if (*scan) (*scan)->since = (*scan)->since ? joined(*(*scan)->since, motion) : motion;
}

void ScanChange::forget() {
  last_.reset();
  unlike_.reset();
  is_confirmed_ = false;
  count_ = 0;
}

bool ScanChange::isComparable(const Reference& before, const Reference& now) {
  if (!before.since || before.sensor_frame != now.sensor_frame) return false;
  if (now.stamp - before.stamp > kLongest) return false;
  const auto& way = before.since->increment;
  const auto& covariance = before.since->covariance;
  return way.position().norm() < kFurthest && std::abs(way.theta()) < kLargestTurn &&
         covariance.topLeftCorner<2, 2>().trace() < kVaguePosition * kVaguePosition &&
         covariance(2, 2) < kVagueHeading * kVagueHeading;
}

bool ScanChange::isUnlike(const Reference& before, const Reference& now) {
  return std::all_of(kSlips.begin(), kSlips.end(), [&](double slip) {
    const Pose2 way = before.since->increment * Pose2(0.0, 0.0, slip);
    return areUnlike(before.profile, now.profile,
                     before.sensor_pose.between(way * now.sensor_pose));
  });
}

void ScanChange::restartFrom(Reference now) {
  forget();
  last_ = std::move(now);
}

bool ScanChange::addUnlike(Reference now) {
  const bool goes_on = unlike_ && isComparable(*unlike_, now) && !isUnlike(*unlike_, now);
  if (!goes_on) unlike_since_ = now.stamp;
  count_ = goes_on ? count_ + 1 : 1;
  unlike_ = std::move(now);
  return count_ >= kInARow && unlike_->stamp - unlike_since_ >= kShortestChange;
}

ScanChange::Verdict ScanChange::judge(const LaserScan& scan) {
  Reference now{ScanProfile(scan), scan.sensor_pose, scan.sensor_frame, scan.stamp, std::nullopt};
  if (now.profile.hits() < kFewestHits) return Verdict::kGoesOn;
  if (!last_ || !isComparable(*last_, now)) {
    restartFrom(std::move(now));
    return Verdict::kGoesOn;
  }
  const bool is_unlike = isUnlike(*last_, now);
  if (!is_unlike || !is_confirmed_) {
    restartFrom(std::move(now));
    is_confirmed_ = !is_unlike;
    return Verdict::kGoesOn;
  }
  if (!addUnlike(std::move(now))) return Verdict::kUnlike;
  restartFrom(std::move(*std::exchange(unlike_, std::nullopt)));
  is_confirmed_ = true;
  return Verdict::kChanged;
}

}  // namespace slam::relocalisation
