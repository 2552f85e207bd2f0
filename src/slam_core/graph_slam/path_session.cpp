// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/landmark_graph.hpp"
#include "slam_core/graph_slam/path_graph.hpp"
#include "slam_core/graph_slam/path_record.hpp"
#include "slam_core/graph_slam/session_graph.hpp"

// How the path and the landmarks go into a session and out of it: the part of each class that
// writes and reads its own members.

namespace slam::graph_slam {

void PathGraph::write(const SessionNumbers& numbers, Session& session) const {
  graph_slam::write(graph_, numbers, session);
  session.robot = {numbers.variable(tail_.node), tail_.motion, start_, tail_.nodes};
}

void PathGraph::read(const Session& session) {
  graph_ = graph::Optimizer();
  build(session, graph_);
  start_ = session.robot.start;
  tail_.motion = session.robot.motion;
  tail_.nodes = session.robot.nodes;
  tail_.node.reset();
  if (session.robot.node) tail_.node = keyOfNode(*session.robot.node);
}

void LandmarkGraph::write(const SessionNumbers& numbers, Session& session) const {
  for (std::size_t i = 0; i < ids_.size(); ++i)
    session.landmarks.push_back({ids_[i], point(i), 0, 0});
  if (sightings_.empty()) return;
  session.sightings_node = numbers.variable(sightings_node_);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const auto known = sightings_.find(i);
    if (known == sightings_.end()) continue;
    const auto& [factor, z, sensor] = known->second;
    session.sightings.push_back({numbers.factor(factor), z, sensor});
  }
}

void LandmarkGraph::read(const Session& session) {
  for (std::size_t i = 0; i < session.landmarks.size(); ++i) {
    ids_.add(session.landmarks[i].id);
    keys_.push_back(keyOfLandmark(session, static_cast<Session::Index>(i)));
  }
  factors_of_.resize(keys_.size());
  for (std::size_t i = 0; i < session.factors.size(); ++i) {
    const auto id = idOfFactor(static_cast<Session::Index>(i));
    if (const auto* prior = std::get_if<Session::PointPrior>(&session.factors[i]))
      factors_of_[prior->landmark].push_back(id);
    if (const auto* seen = std::get_if<Session::RangeBearing>(&session.factors[i]))
      factors_of_[seen->landmark].push_back(id);
  }
  if (session.sightings_node) sightings_node_ = keyOfNode(*session.sightings_node);
  for (const auto& [factor, z, sensor] : session.sightings) {
    const auto& seen = std::get<Session::RangeBearing>(session.factors[factor]);
    sightings_[seen.landmark] = {idOfFactor(factor), z, sensor};
  }
}

void PathRecord::write(const SessionNumbers& numbers, Session& session) const {
  for (const auto& [stamp, node, pose] : marks_) {
    Session::Mark mark{stamp, std::nullopt, pose};
    if (node >= 0) mark.node = numbers.variable(node);
    session.path.push_back(mark);
  }
}

void PathRecord::read(const Session& session) {
  for (const auto& [stamp, node, pose] : session.path)
    marks_.push_back({stamp, node ? keyOfNode(*node) : -1, pose});
}

}  // namespace slam::graph_slam
