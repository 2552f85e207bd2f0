// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>

#include "slam_core/graph_slam/landmark_graph.hpp"
#include "slam_core/graph_slam/node_chain.hpp"
#include "slam_core/graph_slam/path_graph.hpp"
#include "slam_core/graph_slam/path_record.hpp"
#include "slam_core/graph_slam/session_graph.hpp"
#include "slam_core/graph_slam/twist_covariance.hpp"

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
  chain_.read(session);
  start_ = session.robot.start;
  tail_.motion = session.robot.motion;
  tail_.nodes = session.robot.nodes;
  tail_.node.reset();
  if (session.robot.node) tail_.node = keyOfNode(*session.robot.node);
}

/// What joins two nodes that have neighbours already is no motion: it holds both where they are.
void NodeChain::read(const Session& session) {
  for (std::size_t i = 0; i < session.factors.size(); ++i) {
    const auto& factor = session.factors[i];
    if (const auto* prior = std::get_if<Session::PosePrior>(&factor))
      nodes_[keyOfNode(prior->node)].has_prior = true;
    if (const auto* prior = std::get_if<Session::JointPrior>(&factor))
      nodes_[keyOfNode(prior->node)].has_prior = true;
    const auto* motion = std::get_if<Session::Between>(&factor);
    if (!motion) continue;
    auto& before = nodes_[keyOfNode(motion->from)];
    auto& node = nodes_[keyOfNode(motion->to)];
    if (before.after >= 0 || node.before >= 0) {
      before.has_prior = node.has_prior = true;
      continue;
    }
    before.after = keyOfNode(motion->to);
    node.before = keyOfNode(motion->from);
    const Eigen::Matrix3d H = motion->weight.transpose() * motion->weight;
    node.link = {idOfFactor(static_cast<Session::Index>(i)), motion->motion,
                 coordinateCovariance(motion->motion, H.inverse()),
                 motion->motion.position().norm(), false};
  }
  for (std::size_t i = 0; i < session.nodes.size(); ++i)
    if (const auto first = keyOfNode(static_cast<Session::Index>(i)); nodes_[first].before < 0)
      for (auto key = first; key >= 0; key = nodes_[key].after) new_.push_back(key);
}

void LandmarkGraph::write(const SessionNumbers& numbers, Session& session) const {
  for (std::size_t i = 0; i < ids_.size(); ++i)
    session.landmarks.push_back({ids_[i], point(i), 0, 0});
  if (sightings_.empty()) return;
  session.sightings_node = numbers.variable(sightings_node_);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const auto known = sightings_.find(i);
    if (known == sightings_.end()) continue;
    const auto& [z, sensor] = known->second;
    const auto factor = index_.factor(i, sightings_node_);
    session.sightings.push_back({numbers.factor(factor), z, sensor});
  }
}

void LandmarkGraph::read(const Session& session) {
  for (std::size_t i = 0; i < session.landmarks.size(); ++i) {
    ids_.add(session.landmarks[i].id);
    keys_.push_back(keyOfLandmark(session, static_cast<Session::Index>(i)));
    index_.addLandmark();
  }
  for (std::size_t i = 0; i < session.factors.size(); ++i) {
    const auto id = idOfFactor(static_cast<Session::Index>(i));
    if (const auto* prior = std::get_if<Session::PointPrior>(&session.factors[i]))
      index_.addPrior(prior->landmark, id);
    if (const auto* seen = std::get_if<Session::RangeBearing>(&session.factors[i]))
      index_.add(seen->landmark, keyOfNode(seen->node), id);
  }
  if (session.sightings_node) sightings_node_ = keyOfNode(*session.sightings_node);
  for (const auto& [factor, z, sensor] : session.sightings) {
    const auto& seen = std::get<Session::RangeBearing>(session.factors[factor]);
    sightings_[seen.landmark] = {z, sensor};
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
    push({stamp, node ? keyOfNode(*node) : -1, pose});
}

}  // namespace slam::graph_slam
