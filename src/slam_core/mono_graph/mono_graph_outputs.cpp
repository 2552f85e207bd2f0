// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "slam_core/mono_graph/drawing.hpp"
#include "slam_core/mono_graph/mono_graph.hpp"
#include "slam_core/mono_graph/pose_chain.hpp"
#include "slam_core/mono_graph/triangulation.hpp"

namespace slam::mono_graph {

double MonoGraph::radiusOfMap() const {
  double radius = 1.0;
  for (const auto& keyframe : map_.keyframes())
    radius = std::max(radius, (keyframe.pose.position() - pose_.position()).norm());
  return radius;
}

std::optional<Stamp> MonoGraph::lostSince() const {
  std::optional<Stamp> first;
  for (const auto& since : {doubt_.lostSince(), continuity_.lostSince(), standstill_.lostSince()})
    if (since && (!first || *since < *first)) first = since;
  return first;
}

/// A lost robot may be anywhere in the map.
PoseEstimate MonoGraph::pose() const {
  if (isLost()) {
    const Eigen::Vector3d sigmas(radiusOfMap(), radiusOfMap(), M_PI);
    return {pose_, sigmas.cwiseAbs2().asDiagonal()};
  }
  if (!reference_) return {pose_, covariance_};
  const auto& origin = map_.keyframe(*reference_);
  return {pose_, chained(origin.pose, origin.covariance.sum(), pose_, covariance_)};
}

Component::Figures MonoGraph::figures() const {
  return {{"keyframes", static_cast<double>(map_.keyframes().size())},
          {"map_points", static_cast<double>(map_.countOfPoints())}};
}

std::vector<MappedFeature> MonoGraph::features() const {
  std::vector<MappedFeature> mapped;
  const auto& points = map_.points();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].isGone())
      mapped.push_back({i, points[i].position, covarianceOf(map_, points[i])});
  return mapped;
}

cv::Mat MonoGraph::drawing() const { return draw(seen_.gray, seen_.features, seen_.tracked); }

std::optional<ViewStatistics> MonoGraph::viewStatistics() const {
  if (!has_view_) return std::nullopt;
  const auto& tracked = seen_.tracked;
  ViewStatistics view;
  view.features = seen_.features.size();
  view.expected = tracked.expected.size();
  view.matched = tracked.matches.size();
  view.rejected = tracked.rejected.size();
  return view;
}

GraphView MonoGraph::graph() const {
  GraphView view;
  const auto& keyframes = map_.keyframes();
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    view.nodes.push_back(keyframes[i].pose);
    if (keyframes[i].way)
      view.edges.push_back({GraphEdge::Kind::kMotion, keyframes[i - 1].pose.position(),
                            keyframes[i].pose.position()});
  }
  for (const auto& loop : closer_.loops())
    view.edges.push_back({loop.is_believed ? GraphEdge::Kind::kLoop : GraphEdge::Kind::kWaitingLoop,
                          map_.keyframe(loop.earlier).pose.position(),
                          map_.keyframe(loop.later).pose.position(), loop.weight});
  return view;
}

std::vector<StampedPose> MonoGraph::path() const {
  std::vector<StampedPose> path;
  for (const auto& point : path_)
    path.push_back({point.stamp, point.keyframe ? map_.keyframe(*point.keyframe).pose * point.pose
                                                : point.pose});
  return path;
}

std::vector<PlaceVisit> MonoGraph::visits() const {
  std::vector<PlaceVisit> visits;
  for (const auto& point : path_) visits.push_back({point.stamp, point.first_visit});
  return visits;
}

/// The place is that of the first keyframe around that was taken from about here.
std::optional<Stamp> MonoGraph::firstVisit() const {
  constexpr double kSamePlace = 0.5;  // [m, rad]
  if (!is_tracked_) return std::nullopt;
  for (const int number : keyframesAround(map_, *reference_)) {
    const Pose2 apart = map_.keyframe(number).pose.between(pose_);
    if (apart.position().norm() <= kSamePlace && std::abs(apart.theta()) <= kSamePlace)
      return map_.keyframe(number).stamp;
  }
  return map_.keyframe(*reference_).stamp;
}

void MonoGraph::noteLoop(const RecognisedPlace& place, const Pose2& before, const Pose2& after) {
  Event event;
  event.kind = Event::Kind::kLoopClosed;
  const Pose2 moved = before.between(after);
  event.distance = moved.position().norm();
  event.turn = std::abs(moved.theta());
  event.reason = std::to_string(place.matches.size()) + " points that keyframe " +
                 std::to_string(place.keyframe) + " saw are seen again";
  events_.push_back(event);
}

}  // namespace slam::mono_graph
