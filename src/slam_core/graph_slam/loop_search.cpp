// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/loop_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/principal_axes.hpp"

namespace slam::graph_slam {
namespace {

/// From a place further away a laser sees little of what a scan of the submap has seen.
constexpr double kInView = 4.0;  // [m]
constexpr double kSigmas = 3.0;
/// A scan is looked for in so many submaps, the nearest ones.
constexpr std::size_t kMostCandidates = 4;

/// Submaps that follow each other share scans: what is recognised in both counts once.
bool joins(const std::vector<LoopClosure>& closures, graph::Key node) {
  return std::any_of(closures.begin(), closures.end(),
                     [node](const LoopClosure& closure) { return closure.node == node; });
}

double largestSigma(const Eigen::Matrix3d& covariance) {
  return std::sqrt(largestVariance(covariance.topLeftCorner<2, 2>()));
}

}  // namespace

Eigen::Matrix3d covarianceOf(const scan_matching::Match& match, const Eigen::Vector3d& drift) {
  constexpr double kNothing = 1e-4;  // information of what the scan does not tell
  const Eigen::Matrix3d of_match =
      (match.information + kNothing * Eigen::Matrix3d::Identity()).inverse();
  const Eigen::Matrix3d of_map = drift.asDiagonal();
  return twistCovariance(match.pose, of_match) + of_map;
}

std::vector<LoopClosure> LoopSearch::find(const scan_matching::ScanLevels& scan,
                                          const PathGraph& path, Submaps& submaps) const {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < submaps.finished().size(); ++i) {
    const auto& [submap, ended, used] = submaps.finished()[i];
    if (submaps.way() - ended < way_) continue;
    if (const auto found = candidate(i, path, submap)) candidates.push_back(*found);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  candidates.resize(std::min(candidates.size(), kMostCandidates));
  std::vector<LoopClosure> closures;
  for (const auto& candidate : candidates) {
    const auto found = closure(candidate, submaps, scan);
    if (found && !joins(closures, found->node)) closures.push_back(*found);
  }
  return closures;
}

std::optional<LoopSearch::Candidate> LoopSearch::candidate(std::size_t number,
                                                           const PathGraph& path,
                                                           const Submap& submap) const {
  if (submap.isEmpty()) return std::nullopt;
  Candidate result{number, path.graph().pose(submap.origin()).between(path.robot().pose), {}, 0.0};
  const Pose2 place = submap.odomOrigin() * result.origin_node;
  const auto& scan = submap.places()[nearestPlace(submap, place)];
  const double nearest = (scan.position() - place.position()).norm();
  if (nearest > kInView + config_.wide_position) return std::nullopt;
  const Eigen::MatrixXd P = path.covariance({submap.origin()});  // robot, then origin
  const Eigen::Matrix3d A = result.origin_node.inverse().adjoint();
  result.covariance = P.topLeftCorner<3, 3>() + A * P.bottomRightCorner<3, 3>() * A.transpose() -
                      A * P.bottomLeftCorner<3, 3>() - P.topRightCorner<3, 3>() * A.transpose();
  result.distance = nearest;
  if (nearest >
      kInView + std::min(kSigmas * largestSigma(result.covariance), config_.wide_position))
    return std::nullopt;
  return result;
}

std::optional<LoopClosure> LoopSearch::closure(const Candidate& candidate, Submaps& submaps,
                                               const scan_matching::ScanLevels& scan) const {
  const auto& submap = submaps.finished()[candidate.submap].submap;
  const Pose2 place = submap.odomOrigin() * candidate.origin_node;
  const Eigen::Matrix3d variance = (way_ * variance_per_metre_).asDiagonal();
  const Eigen::Matrix3d P = coordinateCovariance(place, candidate.covariance + variance);
  const scan_matching::PosePrior prior{place, P.inverse()};
  const scan_matching::SearchWindow window{
      std::min(config_.wide_position, kSigmas * largestSigma(P)),
      std::min(config_.wide_heading, kSigmas * std::sqrt(P(2, 2)))};
  const auto found = matcher_.recognise(submaps.view(candidate.submap), scan, prior, window);
  if (!found) return std::nullopt;
  const auto [node, pose] = nearestAnchor(submap, found->pose);
  return LoopClosure{node, pose.between(found->pose),
                     covarianceOf(*found, kInView * variance_per_metre_), found->was_searched};
}

}  // namespace slam::graph_slam
