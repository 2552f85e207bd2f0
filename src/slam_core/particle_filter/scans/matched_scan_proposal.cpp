// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <cmath>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/particle_filter/scans/scan_proposal.hpp"

namespace slam::particle_filter {
namespace {

using scan_matching::Match;
using scan_matching::PosePrior;

/// A match may lead further off than motion and drift let expect: a map errs as well.
Eigen::Matrix3d widened(const Eigen::Matrix3d& covariance) {
  constexpr double kPosition = 0.03, kHeading = 0.02;  // [m], [rad]
  Eigen::Matrix3d wide = covariance;
  wide.diagonal() += Eigen::Vector3d(kPosition, kPosition, kHeading).cwiseAbs2();
  return wide;
}

PosePrior searchPrior(const PoseGaussian& prior) {
  return {prior.mean, widened(prior.covariance).inverse()};
}

bool tellsNothing(const ScanInMap& scan, const PoseGaussian& prior) {
  const auto& points = scan.scan.front();
  return points.ends.empty() || scan.map.isEmpty() || !points.isOnMap(prior.mean);
}

/// By three sigmas a prior has lost its say, as in the match itself.
double logOfPrior(const PosePrior& prior, const Pose2& pose) {
  constexpr double kSquaredSigmas = 9.0;
  const Eigen::Vector3d d = difference(pose, prior.pose);
  const double squared = d.dot(prior.information * d);
  return -0.5 * squared / (1.0 + squared / kSquaredSigmas);
}

/// What is left of the pose's uncertainty by motion and match.
Eigen::Matrix3d covarianceOf(const PoseGaussian& prior, const Match& match) {
  constexpr double kFloor = 1e-10;
  if (match.was_searched) return match.information.inverse();
  const Eigen::Matrix3d P = prior.covariance + kFloor * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d posterior = (P.inverse() + match.information).inverse();
  return symmetric(posterior);
}

}  // namespace

std::optional<Pose2> MatchedScanProposal::search(
    const ScanInMap& scan, const PoseGaussian& prior,
    const std::optional<Eigen::Matrix3d>& drift) const {
  if (tellsNothing(scan, prior)) return std::nullopt;
  auto wide = searchPrior(prior);
  if (drift) wide.information_among_older = (widened(prior.covariance) + *drift).inverse();
  constexpr bool kMayUseWideWindow = false;  // ScanFollower has done so
  const auto match = matcher_.match(scan.map, scan.scan, wide, kMayUseWideWindow);
  if (!match.was_searched) return std::nullopt;
  return prior.mean.between(match.pose);
}

ScanDraft MatchedScanProposal::propose(const ScanInMap& scan, const PoseGaussian& prior,
                                       const std::optional<Pose2>& elsewhere, RandomStream&) const {
  if (tellsNothing(scan, prior)) return {prior, scan.log(prior.mean)};
  const auto wide = searchPrior(prior);
  auto match = matcher_.matchNearby(scan.map, scan.scan, wide);
  if (elsewhere && matcher_.isDoubtful(match))
    match = matcher_.orAround(prior.mean * *elsewhere, scan.map, scan.scan, match);
  match = matcher_.believed(match, wide);
  if (!match.is_determined) return {prior, scan.log(prior.mean)};
  const Eigen::Matrix3d posterior = wide.information + match.information;
  const double log_shrinking =
      0.5 * std::log(wide.information.determinant() / posterior.determinant());
  const double log_evidence = scan.log(match.pose) + logOfPrior(wide, match.pose) + log_shrinking;
  return {{match.pose, covarianceOf(prior, match)}, log_evidence};
}

}  // namespace slam::particle_filter
