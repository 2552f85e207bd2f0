// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/dead_reckoning.hpp"

#include <cmath>
#include <iterator>

#include "slam_core/geometry/covariance.hpp"

namespace slam {

void DeadReckoning::predict(const Motion& motion) {
  const double step = motion.increment.position().norm() + std::abs(motion.increment.theta());
  Eigen::Matrix3d J_way, J_step;
  way_ = way_.compose(motion.increment, &J_way, &J_step);
  length_ += step;
  const Eigen::Matrix3d Q = J_step * motion.covariance * J_step.transpose();
  independent_ = symmetric(J_way * independent_ * J_way.transpose() + Q);
  correlated_ = symmetric(J_way * correlated_ * J_way.transpose());
  if (length_ <= kIndependent || correlated_(2, 2) > kUnknownHeading * kUnknownHeading) {
    correlated_ += Q;
    return;
  }
  // The error of a metre, of covariance q, is the sum of equal ones: that of a step s has the
  // covariance s^2 q, where an independent one has Q = s q.
  const double e = step / length_;
  correlated_ = (1.0 + e) * correlated_ + (step + length_) / kIndependent * Q;
}

Eigen::Matrix3d DeadReckoning::covarianceAt(const Pose2& robot) const {
  const Pose2 start(0.0, 0.0, robot.theta() - way_.theta());
  Eigen::Matrix3d to_map = Eigen::Matrix3d::Identity();
  to_map.topLeftCorner<2, 2>() = start.rotation();
  return before_ + to_map * (correlated_ - independent_) * to_map.transpose();
}

void DeadReckoning::know(const LandmarkMap& landmarks) {
  for (const auto& landmark : landmarks) of_landmarks_[landmark.id] = Eigen::Matrix3d::Zero();
}

void DeadReckoning::correct(const std::vector<ObservationInnovation>& innovations,
                            const Pose2& robot) {
  std::vector<LandmarkId> used;
  Eigen::Matrix3d left = covarianceAt(robot);
  for (const auto& innovation : innovations) {
    if (!innovation.used) continue;
    used.push_back(innovation.id);
    const auto known = of_landmarks_.find(innovation.id);
    if (known != of_landmarks_.end() && known->second.trace() < left.trace()) left = known->second;
  }
  if (used.empty()) return;
  for (const auto id : used) of_landmarks_.emplace(id, left);
  beginWay();
  before_ = left;
}

void DeadReckoning::correct(Stamp first_seen, Stamp now, const Pose2& robot) {
  Eigen::Matrix3d left = before_;
  if (length_ > kIndependent) of_stamps_[corrected_] = left = covarianceAt(robot);
  const auto later = of_stamps_.lower_bound(first_seen);
  const Eigen::Matrix3d known =
      later == of_stamps_.begin() ? Eigen::Matrix3d::Zero() : std::prev(later)->second;
  if (known.trace() < left.trace()) of_stamps_[now] = left = known;
  beginWay();
  before_ = left;
  corrected_ = now;
}

void DeadReckoning::beginWay() {
  way_ = Pose2();
  length_ = 0.0;
  independent_.setZero();
  correlated_.setZero();
}

}  // namespace slam
