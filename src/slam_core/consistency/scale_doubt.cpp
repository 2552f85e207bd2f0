// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/scale_doubt.hpp"

#include <cmath>

namespace slam {

void ScaleDoubt::add(const Pose2& odometry, const Pose2& estimated) {
  constexpr double kMemory = 5.0;  // of the way, over which older increments lose their weight [m]
  const Eigen::Vector2d o = odometry.position(), e = estimated.position();
  const double kept = std::exp(-o.norm() / kMemory);
  along_ = kept * along_ + o.dot(e);
  across_ = kept * across_ + o.x() * e.y() - o.y() * e.x();
  square_ = kept * square_ + o.squaredNorm();
  if (square_ <= 0.0) return;
  scale_ = std::hypot(along_, across_) / square_ - 1.0;
  turn_ = std::atan2(across_, along_);
}

Eigen::Matrix3d ScaleDoubt::covariance(const Eigen::Vector2d& from_start) const {
  const Eigen::Vector2d sideways(-from_start.y(), from_start.x());
  Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
  P.topLeftCorner<2, 2>() = scale_ * scale_ * from_start * from_start.transpose() +
                            turn_ * turn_ * sideways * sideways.transpose();
  P(2, 2) = turn_ * turn_;
  P.topRightCorner<2, 1>() = turn_ * turn_ * sideways;
  P.bottomLeftCorner<1, 2>() = P.topRightCorner<2, 1>().transpose();
  return P;
}

}  // namespace slam
