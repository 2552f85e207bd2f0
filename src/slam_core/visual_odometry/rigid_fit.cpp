// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/rigid_fit.hpp"

#include <Eigen/LU>
#include <cmath>

namespace slam::visual_odometry {
namespace {

double weightOf(const PointMatch& match) { return 1.0 / (match.sigma * match.sigma); }

/// Second moments of the points about their weighted means.
struct Moments {
  explicit Moments(const PointMatches& matches) {
    double weight = 0.0;
    for (const auto& match : matches) {
      const double w = weightOf(match);
      weight += w;
      mean_reference += w * match.reference;
      mean_now += w * match.now;
    }
    mean_reference /= weight;
    mean_now /= weight;
    for (const auto& match : matches) {
      const double w = weightOf(match);
      const Eigen::Vector2d a = match.reference - mean_reference, b = match.now - mean_now;
      dot += w * b.dot(a);
      cross += w * (b.x() * a.y() - b.y() * a.x());
      spread_now += w * b.squaredNorm();
    }
  }

  Pose2 pose(double scale) const {
    const Pose2 turn(0.0, 0.0, std::atan2(cross, dot));
    const Eigen::Vector2d t = mean_reference - scale * (turn.rotation() * mean_now);
    return {t.x(), t.y(), turn.theta()};
  }

  Eigen::Vector2d mean_reference = Eigen::Vector2d::Zero(), mean_now = Eigen::Vector2d::Zero();
  double dot = 0.0, cross = 0.0, spread_now = 0.0;
};

}  // namespace

Similarity fitSimilarity(const PointMatches& matches) {
  const Moments moments(matches);
  const double scale =
      moments.spread_now > 0.0 ? std::hypot(moments.dot, moments.cross) / moments.spread_now : 0.0;
  return {scale, moments.pose(scale)};
}

Pose2 fitRigid(const PointMatches& matches) { return Moments(matches).pose(1.0); }

double residualSigma(const PointMatches& matches, const Pose2& T_reference_now) {
  double sum = 0.0;
  for (const auto& match : matches)
    sum += weightOf(match) * (match.reference - T_reference_now.transform(match.now)).squaredNorm();
  const double freedom = 2.0 * static_cast<double>(matches.size()) - 3.0;
  return std::sqrt(sum / freedom);
}

Eigen::Matrix3d rigidCovariance(const PointMatches& matches, const Pose2& T_reference_now) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const auto& match : matches) {
    Eigen::Matrix<double, 2, 3> J;
    T_reference_now.transform(match.now, &J);
    information += weightOf(match) * J.transpose() * J;
  }
  return information.inverse();
}

}  // namespace slam::visual_odometry
