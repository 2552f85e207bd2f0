// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/map_joining.hpp"

#include <Eigen/LU>
#include <cmath>
#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/optimizer.hpp"

namespace slam::seif {
namespace {

constexpr int kSteps = 10;
constexpr double kHeld = 1e6;  // the weight of a base that defines its map's frame [1/m, 1/rad]

/// The variables of a local map that lies at `base`; points that are known already have their keys.
struct Placed {
  std::vector<graph::Key> keys;

  Placed(graph::Optimizer& graph, const graph::LocalMap& map, const Pose2& base,
         std::vector<graph::Key> points = {}) {
    points.resize(map.points.size(), -1);
    keys.push_back(graph.add(base));
    for (const auto& pose : map.poses) keys.push_back(graph.add(base * pose));
    for (std::size_t i = 0; i < points.size(); ++i)
      keys.push_back(points[i] >= 0 ? points[i] : graph.add(base.transform(map.points[i])));
    graph.add(std::make_shared<graph::BasedMap>(keys, map));
  }
};

/// Where the base of the second map lies in the frame of the first one.
Pose2 meetingOf(const graph::LocalMap& first, const graph::LocalMap& second,
                const SharedPoints& shared) {
  std::vector<bool> keeps(second.points.size(), false);
  for (const auto& [a, b] : shared) keeps[b] = true;
  std::vector<Pose2> at(second.points.size());
  for (const auto& [a, b] : shared) at[b] = {first.points[a].x(), first.points[a].y(), 0.0};
  std::vector<Pose2> kept;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (keeps[i]) kept.push_back(at[i]);
  auto part = graph::marginal(second, keeps);
  const auto rows = part.covariance.rows() - 3 * static_cast<Eigen::Index>(part.poses.size());
  part.covariance = part.covariance.bottomRightCorner(rows, rows).eval();
  part.poses.clear();
  return graph::FreeMap(std::vector<graph::Key>(kept.size(), 0), part).base(kept);
}

}  // namespace

bool determinesBase(const graph::LocalMap& map, const std::vector<std::size_t>& points) {
  constexpr double kLargestSigma = 0.1;  // [rad]
  if (points.size() < 2) return false;
  const auto size = 2 * static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd J(size, 3), P(size, size);
  const auto row = [&](std::size_t point) {
    return static_cast<Eigen::Index>(3 * map.poses.size() + 2 * point);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = map.points[points[i]];
    const auto r = 2 * static_cast<Eigen::Index>(i);
    J.middleRows<2>(r) << -1.0, 0.0, p.y(), 0.0, -1.0, -p.x();
    for (std::size_t j = 0; j < points.size(); ++j)
      P.block<2, 2>(r, 2 * static_cast<Eigen::Index>(j)) =
          map.covariance.block<2, 2>(row(points[i]), row(points[j]));
  }
  const Eigen::MatrixXd WJ = graph::weightOfCovariance(P) * J;
  const Eigen::FullPivLU<Eigen::Matrix3d> information(WJ.transpose() * WJ);
  return information.isInvertible() && information.inverse()(2, 2) < kLargestSigma * kLargestSigma;
}

std::optional<graph::LocalMap> joined(const graph::LocalMap& first, const graph::LocalMap& second,
                                      const SharedPoints& shared) {
  std::vector<std::size_t> in_first, in_second;
  for (const auto& [a, b] : shared) {
    in_first.push_back(a);
    in_second.push_back(b);
  }
  if (!determinesBase(first, in_first) || !determinesBase(second, in_second)) return std::nullopt;
  graph::Optimizer graph;
  const Placed of_first(graph, first, Pose2());
  const auto base = of_first.keys[0];
  graph.add(std::make_shared<graph::PosePrior>(base, Pose2(), kHeld * Eigen::Matrix3d::Identity()));
  std::vector<graph::Key> known(second.points.size(), -1);
  for (const auto& [a, b] : shared) known[b] = of_first.keys[1 + first.poses.size() + a];
  const Placed of_second(graph, second, meetingOf(first, second, shared), known);
  if (!graph.optimize({base}, kSteps)) return std::nullopt;

  const auto begin_points = [](const Placed& placed, const graph::LocalMap& map) {
    return placed.keys.begin() + 1 + static_cast<std::ptrdiff_t>(map.poses.size());
  };
  std::vector<graph::Key> keys(of_first.keys.begin() + 1, begin_points(of_first, first));
  keys.insert(keys.end(), of_second.keys.begin() + 1, begin_points(of_second, second));
  const auto poses = keys.size();
  keys.insert(keys.end(), begin_points(of_first, first), of_first.keys.end());
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i] < 0) keys.push_back(of_second.keys[1 + second.poses.size() + i]);
  graph::LocalMap both;
  const Pose2 T_base_map = graph.pose(base).inverse();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto in_base = T_base_map * graph.pose(keys[i]);
    if (i < poses)
      both.poses.push_back(in_base);
    else
      both.points.push_back(in_base.position());
  }
  both.covariance = graph.covariance(keys);
  return both;
}

}  // namespace slam::seif
