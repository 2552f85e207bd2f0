// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/truth_comparison.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <iterator>

#include "slam_core/models/motion.hpp"

namespace slam_ros {
namespace {

constexpr std::size_t kKept = 1000;
constexpr slam::Duration kLargestGap = std::chrono::milliseconds(500);

}  // namespace

void TruthComparison::add(slam::Stamp stamp, const slam::Pose2& truth) {
  if (!truth_.empty() && stamp < truth_.rbegin()->first) truth_.clear();
  truth_[stamp] = truth;
  if (truth_.size() > kKept) truth_.erase(truth_.begin());
}

bool TruthComparison::isExpected(slam::Stamp stamp) const {
  if (truth_.empty()) return false;
  const auto newest = truth_.rbegin()->first;
  return newest < stamp && stamp - newest <= kLargestGap;
}

std::optional<slam::Pose2> TruthComparison::truthAt(slam::Stamp stamp) const {
  const auto after = truth_.lower_bound(stamp);
  if (after == truth_.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == truth_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const auto gap = after->first - before->first;
  if (gap > kLargestGap) return std::nullopt;
  const double share = slam::seconds(stamp - before->first) / slam::seconds(gap);
  return before->second * slam::Pose2::exp(share * before->second.between(after->second).log());
}

std::optional<double> TruthComparison::nees(slam::Stamp stamp, const slam::PoseEstimate& estimate) {
  const auto truth = truthAt(stamp);
  if (!truth || !slam::isCovariance(estimate.covariance)) return std::nullopt;
  if (!T_map_truth_) T_map_truth_ = estimate.pose * truth->inverse();
  const slam::Pose2 expected = *T_map_truth_ * *truth;
  Eigen::Vector3d error = estimate.pose.vector() - expected.vector();
  error.z() = std::remainder(error.z(), 2.0 * M_PI);
  return error.dot(estimate.covariance.llt().solve(error));
}

}  // namespace slam_ros
