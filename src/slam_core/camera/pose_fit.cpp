// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/pose_fit.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/models/chi_square.hpp"

namespace slam {
namespace {

constexpr double kLeastInformation = 1e-3;
constexpr int kRobustSteps = 6, kFinalSteps = 4;
constexpr double kStill = 1e-7;  // [m, rad]

Eigen::Vector3d errorFrom(const Pose2& known, const Pose2& pose) {
  Eigen::Vector3d error = pose.vector() - known.vector();
  error.z() = wrapAngle(error.z());
  return error;
}

/// The squared residual of a sighting in its standard deviations; far where it is not seen at all.
double chi2Of(const NormalisedCamera& camera, const PoseSighting& sighting, const Pose2& pose) {
  const auto seen = camera.project(pose, sighting.point);
  return seen ? (*seen - sighting.seen).squaredNorm() / (sighting.sigma * sighting.sigma) : 1e9;
}

/// The normal equations of all points that count.
struct NormalEquations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();

  void add(const NormalisedCamera& camera, const PoseSighting& sighting, const Pose2& pose,
           bool is_robust) {
    Eigen::Matrix<double, 2, 3> J;
    const auto seen = camera.project(pose, sighting.point, &J);
    if (!seen) return;
    const Eigen::Vector2d r = *seen - sighting.seen;
    double weight = 1.0 / (sighting.sigma * sighting.sigma);
    const double chi2 = weight * r.squaredNorm();
    if (is_robust && chi2 > kGateOfTwo) weight *= std::sqrt(kGateOfTwo / chi2);
    H += weight * J.transpose() * J;
    g += weight * J.transpose() * r;
  }
};

bool isDetermined(const Eigen::Matrix3d& H) {
  return H.allFinite() && principalAxes(H).values(0) > kLeastInformation;
}

/// @return whether the points and the prior determine the step
bool step(const NormalEquations& points, const std::optional<PosePrior>& prior, Pose2& pose) {
  Eigen::Matrix3d H = points.H;
  Eigen::Vector3d g = points.g;
  if (prior) {
    const Eigen::Matrix3d known = prior->covariance.inverse();
    H += known;
    g += known * errorFrom(prior->pose, pose);
  }
  if (!isDetermined(H)) return false;
  pose = Pose2::fromVector(pose.vector() - H.ldlt().solve(g));
  return pose.isFinite();
}

}  // namespace

std::size_t countFits(const NormalisedCamera& camera, const std::vector<PoseSighting>& sightings,
                      const Pose2& pose) {
  std::size_t count = 0;
  for (const auto& sighting : sightings) count += chi2Of(camera, sighting, pose) <= kGateOfTwo;
  return count;
}

std::optional<FittedPose> fitPose(const NormalisedCamera& camera,
                                  const std::vector<PoseSighting>& sightings, const Pose2& start,
                                  const std::optional<PosePrior>& prior) {
  FittedPose fit;
  fit.pose = start;
  NormalEquations equations;
  for (int i = 0; i < kRobustSteps + kFinalSteps; ++i) {
    const bool is_robust = i < kRobustSteps;
    equations = {};
    for (const auto& sighting : sightings)
      if (is_robust || chi2Of(camera, sighting, fit.pose) <= kGateOfTwo)
        equations.add(camera, sighting, fit.pose, is_robust);
    const Pose2 before = fit.pose;
    if (!step(equations, prior, fit.pose)) return std::nullopt;
    if (!is_robust && errorFrom(before, fit.pose).norm() < kStill) break;
  }
  for (const auto& sighting : sightings) {
    fit.fits.push_back(chi2Of(camera, sighting, fit.pose) <= kGateOfTwo);
    fit.count += fit.fits.back();
  }
  fit.information = equations.H;
  const Eigen::Matrix3d all =
      prior ? Eigen::Matrix3d(equations.H + prior->covariance.inverse()) : equations.H;
  fit.covariance = all.inverse();
  return fit;
}

}  // namespace slam
