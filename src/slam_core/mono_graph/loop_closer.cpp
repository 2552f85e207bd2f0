// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/loop_closer.hpp"

#include <map>
#include <memory>
#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/optimizer.hpp"
#include "slam_core/graph/robust_loops.hpp"
#include "slam_core/mono_graph/local_mapper.hpp"
#include "slam_core/mono_graph/pose_chain.hpp"

namespace slam::mono_graph {
namespace {

constexpr double kOriginVariance = 1e-8;  // [m^2, rad^2]
constexpr std::size_t kMostLinks = 4;     // of a keyframe to earlier ones
constexpr int kMostSettlingSteps = 20;
constexpr std::size_t kJoinedNeighbours = 6;

/// A covariance of coordinates in the map frame, as one of the coordinates relative to an origin.
Eigen::Matrix3d relativeTo(const Pose2& origin, const Eigen::Matrix3d& covariance) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = origin.rotation().transpose();
  return R * covariance * R.transpose();
}

std::shared_ptr<const graph::Factor> factorOf(const Loop& loop) {
  return std::make_shared<graph::Between>(loop.earlier, loop.later, loop.measured,
                                          graph::weightOfCovariance(loop.covariance));
}

/// The keyframes of a map as they lie, joined by the points that they share, or by odometry.
void addKeyframes(const VisualMap& map, graph::Optimizer& poses) {
  for (const auto& keyframe : map.keyframes()) poses.add(keyframe.pose);
  const Eigen::Matrix3d W =
      graph::weightOfCovariance(kOriginVariance * Eigen::Matrix3d::Identity());
  poses.add(std::make_shared<graph::PosePrior>(0, map.keyframe(0).pose, W));
  for (int i = 1; i < static_cast<int>(map.keyframes().size()); ++i)
    for (const auto& link : linksOf(map, i, kMostLinks)) {
      const auto& earlier = map.keyframe(link.earlier).pose;
      poses.add(std::make_shared<graph::Between>(
          link.earlier, i, earlier.between(map.keyframe(i).pose),
          graph::weightOfCovariance(relativeTo(earlier, link.covariance))));
    }
}

}  // namespace

LoopCloser::Closed LoopCloser::close(VisualMap& map, const RecognisedPlace& place, int keyframe) {
  graph::Optimizer poses;
  addKeyframes(map, poses);
  graph::RobustLoops robust(poses, graph::RobustLoops::Noise::kAsTold);
  std::vector<graph::RobustLoops::State> states;
  for (const auto& loop : loops_)
    states.push_back({factorOf(loop), loop.is_believed, loop.weight, loop.is_alone});
  robust.restore(states);
  const auto settle = [&] { poses.optimize({keyframe}, kMostSettlingSteps); };
  settle();
  const auto& earlier = map.keyframe(place.keyframe).pose;
  loops_.push_back({place.keyframe, keyframe, earlier.between(place.pose),
                    relativeTo(earlier, place.covariance)});
  robust.add(factorOf(loops_.back()));
  robust.judge(settle);
  const auto judged = robust.states();
  Closed closed{0, judged.back().is_believed};
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    closed.loops += judged[i].is_believed && !loops_[i].is_believed;
    loops_[i].is_believed = judged[i].is_believed;
    loops_[i].weight = judged[i].weight;
    loops_[i].is_alone = judged[i].is_alone;
  }
  if (closed.loops == 0) return closed;
  std::vector<Pose2> moved;
  for (int i = 0; i < static_cast<int>(map.keyframes().size()); ++i) moved.push_back(poses.pose(i));
  moveKeyframes(map, moved);
  return closed;
}

void joinPlaces(VisualMap& map, const RecognisedPlace& place, int keyframe) {
  for (const auto& match : place.matches) {
    const int mine = map.keyframe(keyframe).points[match.feature];
    if (mine == kNoPoint)
      map.addSighting(match.point, {keyframe, static_cast<int>(match.feature)});
    else if (mine != match.point && !map.point(match.point).isGone())
      map.merge(match.point, mine);
  }
  const auto points = pointsSeenBy(map, keyframesAround(map, place.keyframe));
  auto neighbours = neighboursOf(map, keyframe, kJoinedNeighbours);
  neighbours.push_back(keyframe);
  joinPoints(map, points, neighbours);
}

}  // namespace slam::mono_graph
