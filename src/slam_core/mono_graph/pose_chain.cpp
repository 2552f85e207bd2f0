// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/pose_chain.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "slam_core/geometry/covariance.hpp"

namespace slam::mono_graph {
namespace {

constexpr int kLinkPoints = 20;       // points that make a link of a chain
constexpr double kLeastWay = 0.05;    // [m] by odometry, that tells its noise
constexpr double kPersistence = 4.0;  // of the variance of the scale
constexpr double kDependence = 4.0;   // of the points: their positions come from the same keyframes

/// How well the points that both see determine the pose of the one relative to the other.
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

/// How long the way between two keyframes is, one camera cannot tell: only odometry does. Its
/// errors stay in the scale of the points for the length of some neighbourhoods, so that they add
/// up to more than those of odometry itself.
Eigen::Matrix3d scaleCovariance(const Keyframe& keyframe, const Keyframe& other) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const double length = keyframe.way ? keyframe.way->position().norm() : 0.0;
  if (length < kLeastWay) return covariance;
  const double per_metre = keyframe.way_covariance.topLeftCorner<2, 2>().trace() / length;
  const Eigen::Vector2d apart = keyframe.pose.position() - other.pose.position();
  if (apart.norm() > 0.0)
    covariance.topLeftCorner<2, 2>() =
        kPersistence * per_metre * apart * apart.transpose() / apart.norm();
  return covariance;
}

/// Which of two chains leaves more; a radian counts as a metre.
double sizeOf(const Eigen::Matrix3d& covariance) { return covariance.trace(); }

}  // namespace

Eigen::Matrix3d chained(const Pose2& origin, const Eigen::Matrix3d& of_origin, const Pose2& pose,
                        const Eigen::Matrix3d& of_pose) {
  Eigen::Matrix3d J;
  origin.compose(origin.between(pose), &J);
  return symmetric(J * of_origin * J.transpose() + of_pose);
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
        kDependence * H.inverse() +
        scaleCovariance(map.keyframe(number), map.keyframe(each.second));
    if (covariance.allFinite() && covariance.diagonal().minCoeff() > 0.0)
      links.push_back({each.second, covariance});
  }
  const auto& keyframe = map.keyframe(number);
  if (!links.empty() || !keyframe.way) return links;
  Eigen::Matrix3d J;
  map.keyframe(number - 1).pose.compose(*keyframe.way, nullptr, &J);
  return {{number - 1, J * keyframe.way_covariance * J.transpose()}};
}

std::optional<Eigen::Matrix3d> chainedCovariance(const VisualMap& map, int number) {
  std::optional<Eigen::Matrix3d> best;
  const auto& keyframe = map.keyframe(number);
  for (const auto& link : linksOf(map, number, map.keyframes().size())) {
    const auto& earlier = map.keyframe(link.earlier);
    const auto covariance =
        chained(earlier.pose, earlier.covariance, keyframe.pose, link.covariance);
    if (covariance.allFinite() && (!best || sizeOf(covariance) < sizeOf(*best))) best = covariance;
  }
  return best;
}

}  // namespace slam::mono_graph
