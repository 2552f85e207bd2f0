// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <algorithm>
#include <set>

#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/session_parts.hpp"

namespace slam::graph_slam {

void SessionParts::write(const PathGraph& path, const SessionNumbers& numbers, Session& session) {
  graph_slam::write(path.graph_, numbers, session);
  write(path.chain_, numbers, session);
  const auto& tail = path.tail_;
  session.robot = {numbers.variable(tail.node), tail.motion, path.start_, tail.nodes};
}

void SessionParts::read(const Session& session, PathGraph& path) {
  path.graph_ = graph::Optimizer();
  build(session, path.graph_);
  read(session, path.chain_);
  path.start_ = session.robot.start;
  path.tail_ = {std::nullopt, session.robot.motion, session.robot.nodes};
  if (session.robot.node) path.tail_.node = keyOfNode(*session.robot.node);
}

void SessionParts::write(const NodeChain& chain, const SessionNumbers& numbers, Session& session) {
  std::set<Session::Index> chords;  // each is at both of its nodes
  for (const auto key : numbers.nodes())
    if (const auto node = chain.nodes_.find(key); node != chain.nodes_.end())
      for (const auto& chord : node->second.chords) chords.insert(numbers.factor(chord.factor));
  session.chords.assign(chords.begin(), chords.end());
}

/// A factor between two nodes that have neighbours already is no motion: it ties both to the map.
void SessionParts::read(const Session& session, NodeChain& chain) {
  auto& nodes = chain.nodes_;
  for (std::size_t i = 0; i < session.factors.size(); ++i) {
    const auto& factor = session.factors[i];
    if (const auto* prior = std::get_if<Session::PosePrior>(&factor))
      nodes[keyOfNode(prior->node)].has_prior = true;
    if (const auto* prior = std::get_if<Session::JointPrior>(&factor))
      nodes[keyOfNode(prior->node)].has_prior = true;
    const auto* motion = std::get_if<Session::Between>(&factor);
    if (!motion) continue;
    auto& before = nodes[keyOfNode(motion->from)];
    auto& node = nodes[keyOfNode(motion->to)];
    const auto id = idOfFactor(static_cast<Session::Index>(i));
    if (std::binary_search(session.chords.begin(), session.chords.end(), i)) {
      before.chords.push_back({id, keyOfNode(motion->to)});
      node.chords.push_back({id, keyOfNode(motion->from)});
      continue;
    }
    if (before.after >= 0 || node.before >= 0) {
      before.has_prior = node.has_prior = true;
      continue;
    }
    before.after = keyOfNode(motion->to);
    node.before = keyOfNode(motion->from);
    const Eigen::Matrix3d H = motion->weight.transpose() * motion->weight;
    node.link = {id,
                 {motion->motion},
                 coordinateCovariance(motion->motion, H.inverse()),
                 motion->motion.position().norm()};
  }
  for (std::size_t i = 0; i < session.nodes.size(); ++i)
    if (const auto first = keyOfNode(static_cast<Session::Index>(i)); nodes[first].before < 0)
      for (auto key = first; key >= 0; key = nodes[key].after) chain.new_.push_back(key);
}

void SessionParts::write(const LandmarkGraph& from, const SessionNumbers& numbers,
                         Session& session) {
  for (std::size_t i = 0; i < from.ids_.size(); ++i)
    session.landmarks.push_back(
        {from.ids_[i], from.point(i), 0, 0, from.ids_.isRetired(i), Descriptor()});
  if (from.sightings_.empty()) return;
  session.sightings_node = numbers.variable(from.sightings_node_);
  for (std::size_t i = 0; i < from.ids_.size(); ++i) {
    const auto known = from.sightings_.find(i);
    if (known == from.sightings_.end()) continue;
    const auto seen = from.renewed(known->second);
    const auto factor = from.index_.factor(i, from.sightings_node_);
    session.sightings.push_back({numbers.factor(factor), seen.z, seen.sensor});
  }
}

void SessionParts::read(const Session& session, LandmarkGraph& to) {
  for (std::size_t i = 0; i < session.landmarks.size(); ++i) {
    to.ids_.add(session.landmarks[i].id);
    if (session.landmarks[i].is_retired) to.ids_.retire(to.ids_[i]);
    to.keys_.push_back(keyOfLandmark(session, static_cast<Session::Index>(i)));
    to.index_.addLandmark();
  }
  for (std::size_t i = 0; i < session.factors.size(); ++i) {
    const auto id = idOfFactor(static_cast<Session::Index>(i));
    if (const auto* prior = std::get_if<Session::PointPrior>(&session.factors[i]))
      to.index_.addPrior(prior->landmark, id);
    if (const auto* seen = std::get_if<Session::RangeBearing>(&session.factors[i]))
      to.index_.add(seen->landmark, keyOfNode(seen->node), id);
  }
  if (session.sightings_node) to.sightings_node_ = keyOfNode(*session.sightings_node);
  for (const auto& [factor, z, sensor] : session.sightings) {
    const auto& seen = std::get<Session::RangeBearing>(session.factors[factor]);
    to.sightings_[seen.landmark] = {z, sensor, {}};
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
    record.push({stamp, node ? keyOfNode(*node) : -1, pose});
}

}  // namespace slam::graph_slam
