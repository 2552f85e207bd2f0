// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_scan_odometry_toy/scan_alignment.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

// Symbols: p point, q its nearest reference point, n normal of the reference there, r distances to
// the lines, A = J^T J and b = J^T r of their Jacobian by the pose.

namespace slam_toy {
namespace {

constexpr int kIterations = 30;
constexpr double kFarAtFirst = 0.5;  // a nearest point beyond this is another object's [m]
constexpr double kFarAtLast = 0.1;
constexpr double kLongestLine = 0.5;    // neighbours further apart are not of one surface [m]
constexpr double kLeastSigma = 0.01;    // of a range: residuals of 0 are luck [m]
constexpr double kShared = 4.0;         // both scans err, and so do neighbouring beams alike
constexpr std::size_t kFewest = 20;     // points that have to fit
constexpr double kLeastSupport = 0.02;  // share of the points that speak of every direction

struct Fit {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double squares = 0.0;
  std::size_t count = 0;

  bool isDetermined() const {
    if (count < kFewest) return false;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(A, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()(0) > kLeastSupport * static_cast<double>(count);
  }
};

/// Of the inner points: the ends have no neighbour on one side.
std::size_t nearest(const Points& reference, const Eigen::Vector2d& p) {
  std::size_t best = 1;
  for (std::size_t i = 2; i + 1 < reference.size(); ++i)
    if ((reference[i] - p).squaredNorm() < (reference[best] - p).squaredNorm()) best = i;
  return best;
}

Fit fit(const Points& reference, const Points& points, const slam::Pose2& pose, double far) {
  Fit fit;
  for (const auto& point : points) {
    Eigen::Matrix<double, 2, 3> J_p;
    const Eigen::Vector2d p = pose.transform(point, &J_p);
    const auto at = nearest(reference, p);
    const Eigen::Vector2d line = reference[at + 1] - reference[at - 1];
    if ((reference[at] - p).norm() > far || line.norm() > kLongestLine || line.norm() < 1e-6)
      continue;
    const Eigen::Vector2d n = Eigen::Vector2d(-line.y(), line.x()).normalized();
    const double r = n.dot(p - reference[at]);
    const Eigen::Vector3d J = J_p.transpose() * n;
    fit.A += J * J.transpose();
    fit.b += J * r;
    fit.squares += r * r;
    ++fit.count;
  }
  return fit;
}

}  // namespace

Points pointsOf(const slam::LaserScan& scan) {
  Points points;
  const std::size_t every = (scan.beams.size() + kMostPoints - 1) / kMostPoints;
  for (std::size_t i = 0; i < scan.beams.size(); i += every)
    if (scan.beams[i].hit) points.push_back(scan.sensor_pose.transform(scan.beams[i].end()));
  return points;
}

std::optional<Alignment> align(const Points& reference, const Points& points,
                               const slam::Pose2& guess) {
  if (reference.size() < 3) return std::nullopt;
  Alignment alignment{guess};
  for (int i = 0; i < kIterations; ++i) {
    const double far = std::max(kFarAtLast, kFarAtFirst * std::pow(0.8, i));
    const auto found = fit(reference, points, alignment.pose, far);
    if (!found.isDetermined()) return std::nullopt;
    const Eigen::Vector3d step = found.A.ldlt().solve(found.b);
    alignment.pose = slam::Pose2::fromVector(alignment.pose.vector() - step);
    const double variance = found.squares / static_cast<double>(found.count);
    alignment.covariance = kShared * std::max(variance, kLeastSigma * kLeastSigma) *
                           found.A.ldlt().solve(Eigen::Matrix3d::Identity());
  }
  alignment.covariance = (0.5 * (alignment.covariance + alignment.covariance.transpose())).eval();
  return alignment;
}

Alignment coasted(const Eigen::Vector3d& twist, double dt) {
  Alignment alignment{slam::Pose2::exp(dt * twist)};
  alignment.covariance.diagonal().setConstant(dt * dt);  // 1 m/s, 1 rad/s
  return alignment;
}

}  // namespace slam_toy
