// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_parts.hpp"

namespace slam::graph_slam {

void SessionParts::write(const PathGraph& path, const SessionNumbers& numbers, Session& session) {
  graph_slam::write(path.graph_, numbers, session);
  const auto& tail = path.tail_;
  session.robot = {numbers.variable(tail.node), tail.motion, path.start_, tail.nodes};
}

void SessionParts::read(const Session& session, PathGraph& path) {
  path.graph_ = graph::Optimizer();
  build(session, path.graph_);
  path.start_ = session.robot.start;
  path.tail_ = {std::nullopt, session.robot.motion, session.robot.nodes};
  if (session.robot.node) path.tail_.node = keyOfNode(*session.robot.node);
}

void SessionParts::write(const LandmarkGraph& from, const SessionNumbers& numbers,
                         Session& session) {
  for (std::size_t i = 0; i < from.ids_.size(); ++i)
    session.landmarks.push_back({from.ids_[i], from.point(i), 0, 0});
  if (from.sightings_.empty()) return;
  session.sightings_node = numbers.variable(from.sightings_node_);
  for (std::size_t i = 0; i < from.ids_.size(); ++i) {
    const auto known = from.sightings_.find(i);
    if (known == from.sightings_.end()) continue;
    const auto& [factor, z, sensor] = known->second;
    session.sightings.push_back({numbers.factor(factor), z, sensor});
  }
}

void SessionParts::read(const Session& session, LandmarkGraph& to) {
  for (std::size_t i = 0; i < session.landmarks.size(); ++i) {
    to.ids_.add(session.landmarks[i].id);
    to.keys_.push_back(keyOfLandmark(session, static_cast<Session::Index>(i)));
  }
  to.factors_of_.resize(to.keys_.size());
  for (std::size_t i = 0; i < session.factors.size(); ++i) {
    const auto id = idOfFactor(static_cast<Session::Index>(i));
    if (const auto* prior = std::get_if<Session::PointPrior>(&session.factors[i]))
      to.factors_of_[prior->landmark].push_back(id);
    if (const auto* seen = std::get_if<Session::RangeBearing>(&session.factors[i]))
      to.factors_of_[seen->landmark].push_back(id);
  }
  if (session.sightings_node) to.sightings_node_ = keyOfNode(*session.sightings_node);
  for (const auto& [factor, z, sensor] : session.sightings) {
    const auto& seen = std::get<Session::RangeBearing>(session.factors[factor]);
    to.sightings_[seen.landmark] = {idOfFactor(factor), z, sensor};
  }
}

void SessionParts::write(const PathRecord& record, const SessionNumbers& numbers,
                         Session& session) {
  for (const auto& [stamp, node, pose] : record.marks_) {
    Session::Mark mark{stamp, std::nullopt, pose};
    if (node >= 0) mark.node = numbers.variable(node);
    session.path.push_back(mark);
  }
}

void SessionParts::read(const Session& session, PathRecord& record) {
  for (const auto& [stamp, node, pose] : session.path)
    record.marks_.push_back({stamp, node ? keyOfNode(*node) : -1, pose});
}

}  // namespace slam::graph_slam
