// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trajectory_error.hpp"

#include <cmath>

namespace slam::eval {
namespace {

Eigen::Vector2d centre(const std::vector<Pose2>& poses) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& pose : poses) sum += pose.position();
  return sum / static_cast<double>(poses.size());
}

}  // namespace

Pose2 alignment(const std::vector<Pose2>& poses, const std::vector<Pose2>& others) {
  const Eigen::Vector2d from = centre(poses), to = centre(others);
  double cosine = 0.0, sine = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector2d p = poses[i].position() - from, q = others[i].position() - to;
    cosine += p.dot(q);
    sine += p.x() * q.y() - p.y() * q.x();
  }
  const Pose2 turn(0, 0, std::atan2(sine, cosine));
  const Eigen::Vector2d shift = to - turn.transform(from);
  return {shift.x(), shift.y(), turn.theta()};
}

double positionError(const std::vector<Pose2>& poses, const std::vector<Pose2>& truth) {
  const Pose2 T_truth_map = alignment(poses, truth);
  double sum = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    sum += (T_truth_map.transform(poses[i].position()) - truth[i].position()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

}  // namespace slam::eval
