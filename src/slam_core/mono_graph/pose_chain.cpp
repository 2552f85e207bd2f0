// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/pose_chain.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/consistency/dead_reckoning.hpp"
#include "slam_core/geometry/covariance.hpp"

namespace slam::mono_graph {
namespace {

constexpr int kLinkPoints = 20;       // points that make a link of a chain
constexpr double kLeastWay = 0.05;    // [m] by odometry, that tells its noise
constexpr double kPersistence = 4.0;  // of the variance of the scale
constexpr double kDependence = 4.0;   // of the points: their positions come from the same keyframes

/// @return the information about the pose of one relative to the other, by the points that both see
Eigen::Matrix3d sharedInformation(const VisualMap& map, int number, int other) {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  const auto& keyframe = map.keyframe(number);
  for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
    if (keyframe.points[i] == kNoPoint) continue;
    const auto& point = map.point(keyframe.points[i]);
    bool is_shared = false;
    for (const auto& sighting : point.sightings) is_shared |= sighting.keyframe == other;
    Eigen::Matrix<double, 2, 3> J;
    const auto& features = keyframe.features;
    if (!is_shared || !features.camera().project(keyframe.pose, point.position, &J)) continue;
    H += J.transpose() * J / (features[i].sigma * features[i].sigma);
  }
  return H;
}

/// Which of two chains leaves more; a radian counts as a metre.
double sizeOf(const Eigen::Matrix3d& covariance) { return covariance.trace(); }

/// Odometry's error behind a link by odometry alone.
/// @param before that of the way so far, as an error of the pose now @param way of the link [m]
Eigen::Matrix3d withLink(const Eigen::Matrix3d& before, double way_before,
                         const Eigen::Matrix3d& of_link, double way) {
  constexpr double kIndependent = DeadReckoning::kIndependent;
  if (!(way_before > 0.0)) return std::max(1.0, way / kIndependent) * of_link;
  const double whole = way_before + way;
  if (whole <= kIndependent || before(2, 2) > std::pow(DeadReckoning::kUnknownHeading, 2))
    return before + of_link;
  return (1.0 + way / whole) * before + (way + whole) / kIndependent * of_link;
}

ChainCovariance throughLink(const VisualMap& map, int number, const Link& link) {
  const auto &keyframe = map.keyframe(number), &earlier = map.keyframe(link.earlier);
  const auto& known = earlier.covariance;
  const Eigen::Matrix3d nothing = Eigen::Matrix3d::Zero();
  const auto& of_points = link.is_by_odometry ? nothing : link.covariance;
  ChainCovariance chain;
  chain.by_points = chained(earlier.pose, known.by_points, keyframe.pose, of_points);
  chain.by_odometry = chained(earlier.pose, known.by_odometry, keyframe.pose, nothing);
  chain.odometry_way = known.odometry_way;
  if (!link.is_by_odometry) return chain;
  const double way = keyframe.way->position().norm() + std::abs(keyframe.way->theta());
  chain.by_odometry = withLink(chain.by_odometry, chain.odometry_way, link.covariance, way);
  chain.odometry_way += way;
  return chain;
}

}  // namespace

Eigen::Matrix3d chained(const Pose2& origin, const Eigen::Matrix3d& of_origin, const Pose2& pose,
                        const Eigen::Matrix3d& of_pose) {
  Eigen::Matrix3d J;
  origin.compose(origin.between(pose), &J);
  return symmetric(J * of_origin * J.transpose() + of_pose);
}

Eigen::Matrix3d scaleCovariance(const VisualMap& map, int number, const Pose2& pose) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const bool is_last = number + 1 == static_cast<int>(map.keyframes().size());
  const auto& keyframe = map.keyframe(number);
  const auto& measured = keyframe.way || is_last ? keyframe : map.keyframe(number + 1);
  const double length = measured.way ? measured.way->position().norm() : 0.0;
  const Eigen::Vector2d apart = pose.position() - keyframe.pose.position();
  if (length < kLeastWay || !(apart.norm() > 0.0)) return covariance;
  const double per_metre = measured.way_covariance.topLeftCorner<2, 2>().trace() / length;
  covariance.topLeftCorner<2, 2>() =
      kPersistence * per_metre * apart * apart.transpose() / apart.norm();
  return covariance;
}

std::vector<Link> linksOf(const VisualMap& map, int number, std::size_t most) {
  std::vector<std::pair<int, int>> ranked;  // by number of points, the newer one first
  for (const auto& [other, shared] : sharedPoints(map, number))
    if (shared >= kLinkPoints && other < number) ranked.emplace_back(shared, other);
  std::sort(ranked.rbegin(), ranked.rend());
  if (ranked.size() > most) ranked.resize(most);
  std::vector<Link> links;
  for (const auto& each : ranked) {
    const Eigen::Matrix3d H = sharedInformation(map, number, each.second);
    const Eigen::Matrix3d covariance =
        kDependence * H.inverse() + scaleCovariance(map, number, map.keyframe(each.second).pose);
    if (covariance.allFinite() && covariance.diagonal().minCoeff() > 0.0)
      links.push_back({each.second, covariance, false});
  }
  const auto& keyframe = map.keyframe(number);
  if (!links.empty() || !keyframe.way) return links;
  Eigen::Matrix3d J;
  map.keyframe(number - 1).pose.compose(*keyframe.way, nullptr, &J);
  return {{number - 1, J * keyframe.way_covariance * J.transpose(), true}};
}

std::optional<ChainCovariance> chainedCovariance(const VisualMap& map, int number) {
  std::optional<ChainCovariance> best;
  for (const auto& link : linksOf(map, number, map.keyframes().size())) {
    const auto chain = throughLink(map, number, link);
    const Eigen::Matrix3d sum = chain.sum();
    if (sum.allFinite() && (!best || sizeOf(sum) < sizeOf(best->sum()))) best = chain;
  }
  return best;
}

}  // namespace slam::mono_graph
