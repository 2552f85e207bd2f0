// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/node_chain.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/twist_covariance.hpp"

namespace slam::graph_slam {

namespace {

/// @return both motions as one, to the first order in their errors
NodeChain::Link composed(const NodeChain::Link& first, const NodeChain::Link& second) {
  Eigen::Matrix3d J_first, J_second;
  NodeChain::Link both;
  both.increment = first.increment.compose(second.increment, &J_first, &J_second);
  both.covariance = J_first * first.covariance * J_first.transpose() +
                    J_second * second.covariance * J_second.transpose();
  both.way = first.way + second.way;
  return both;
}

/// The Jacobians do not show that an error e of the heading shortens the way by about e^2 / 2 of
/// its length. The second moment of e^2 / 2 is 3/4 sigma^4.
Eigen::Matrix3d ofSecondOrder(const NodeChain::Link& link) {
  const double shortened = 0.75 * std::pow(link.covariance(2, 2) * link.way, 2);
  return Eigen::Vector3d(shortened, shortened, 0.0).asDiagonal();
}

}  // namespace

void NodeChain::start(graph::Key node) {
  nodes_[node].has_prior = true;
  new_.push_back(node);
}

void NodeChain::append(graph::Key before, graph::Key node, const Motion& motion) {
  Link link;
  link.increment = motion.increment;
  link.covariance = motion.covariance;
  link.way = motion.increment.position().norm();
  join(before, node, link);
  new_.push_back(node);
}

void NodeChain::join(graph::Key before, graph::Key node, const Link& link) {
  const Eigen::Matrix3d P = link.covariance + ofSecondOrder(link);
  const auto W = graph::weightOfCovariance(twistCovariance(link.increment, P));
  auto& joined = nodes_[node];
  joined.before = before;
  joined.link = link;
  joined.link.factor =
      graph_.add(std::make_unique<graph::Between>(before, node, link.increment, W));
  nodes_[before].after = node;
}

void NodeChain::addChord(graph::Key from, graph::Key node, const Pose2& motion,
                         const Eigen::Matrix3d& W) {
  const auto factor = graph_.add(std::make_unique<graph::Between>(from, node, motion, W));
  nodes_.at(from).chords.push_back({factor, node});
  nodes_.at(node).chords.push_back({factor, from});
}

void NodeChain::loosen(graph::Key key, const Eigen::Matrix3d& more) {
  const auto& node = nodes_.at(key);
  if (node.before < 0) return;
  Link link = node.link;
  graph_.remove(link.factor);
  link.covariance += coordinateCovariance(link.increment, more);
  join(node.before, key, link);
}

void NodeChain::remove(graph::Key key) {
  removeChords(key);
  const Node node = nodes_.at(key);
  cut(key);
  if (node.after >= 0) {
    const Link next = nodes_.at(node.after).link;
    cut(node.after);
    if (node.before >= 0) join(node.before, node.after, composed(node.link, next));
  }
  nodes_.erase(key);
  removeVariable(graph_, key);
}

void NodeChain::cut(graph::Key key) {
  auto& node = nodes_.at(key);
  if (node.before < 0) return;
  graph_.remove(node.link.factor);
  nodes_.at(node.before).after = -1;
  node.before = -1;
  node.link = {};
}

void NodeChain::removeChords(graph::Key key) {
  for (const auto& chord : nodes_.at(key).chords) {
    graph_.remove(chord.factor);
    auto& others = nodes_.at(chord.other).chords;
    others.erase(std::find_if(others.begin(), others.end(),
                              [&](const Chord& other) { return other.factor == chord.factor; }));
  }
  nodes_.at(key).chords.clear();
}

}  // namespace slam::graph_slam
