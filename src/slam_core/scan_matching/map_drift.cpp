// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/map_drift.hpp"

#include <cmath>

namespace slam::scan_matching {
namespace {

constexpr double kEdge = 1.0;  // of a square [m]

std::uint64_t squareOf(const Pose2& pose, int right, int up) {
  const auto index = [](double length, int more) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(length / kEdge)) + more);
  };
  return std::uint64_t{index(pose.x(), right)} << 32 | index(pose.y(), up);
}

double positionVariance(const Eigen::Matrix3d& covariance) {
  return covariance.topLeftCorner<2, 2>().trace();
}

}  // namespace

void MapDrift::restart(const PoseEstimate& first) {
  last_ = first;
  oldest_.clear();
  oldest_.emplace(squareOf(first.pose, 0, 0), Place{0, first});
}

const PoseEstimate& MapDrift::oldestNearby(const Pose2& pose) const {
  const Place* oldest = nullptr;
  for (int right = -1; right <= 1; ++right)
    for (int up = -1; up <= 1; ++up) {
      const auto found = oldest_.find(squareOf(pose, right, up));
      if (found == oldest_.end()) continue;
      if (oldest == nullptr || found->second.age_rank < oldest->age_rank) oldest = &found->second;
    }
  return oldest == nullptr ? last_ : oldest->pose;
}

Eigen::Matrix3d MapDrift::covarianceAt(const Pose2& pose) const {
  const auto& place = oldestNearby(pose);
  const Pose2 way = place.pose.between(pose);
  Eigen::Matrix3d J_place;
  place.pose.compose(way, &J_place);
  Eigen::Matrix3d P = J_place * place.covariance * J_place.transpose();
  P.diagonal() += way.position().norm() * variance_per_metre_;
  return P;
}

bool MapDrift::isSurerThan(const PoseEstimate& robot) const {
  constexpr double kVague = 0.2;  // [m]
  const double variance = positionVariance(robot.covariance);
  return variance > kVague * kVague && variance > positionVariance(covarianceAt(robot.pose));
}

void MapDrift::add(const Pose2& pose) {
  last_ = {pose, covarianceAt(pose)};
  oldest_.emplace(squareOf(pose, 0, 0), Place{oldest_.size(), last_});
}

}  // namespace slam::scan_matching
