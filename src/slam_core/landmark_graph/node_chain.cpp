// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/node_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/landmark_graph/twist_covariance.hpp"

namespace slam::landmark_graph {

namespace {

/// @return both motions as one, to the first order in their errors
NodeChain::Link composed(const NodeChain::Link& first, const NodeChain::Link& second) {
  Eigen::Matrix3d J_first, J_second;
  NodeChain::Link both;
  both.motion.increment =
      first.motion.increment.compose(second.motion.increment, &J_first, &J_second);
  both.motion.J = J_first * first.motion.J + J_second * second.motion.J;
  both.motion.at = second.motion.at;
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

void NodeChain::append(graph::Key before, graph::Key node, const Motion& motion,
                       const graph::WheelMotion& by_wheels) {
  Link link;
  link.motion = by_wheels;
  link.motion.increment = motion.increment;
  link.covariance = motion.covariance;
  link.way = motion.increment.position().norm();
  join(before, node, link);
  new_.push_back(node);
}

void NodeChain::join(graph::Key before, graph::Key node, const Link& link) {
  auto& joined = nodes_[node];
  joined.before = before;
  joined.link = link;
  joined.link.factor = graph_.add(factorOf(before, node, link));
  nodes_[before].after = node;
}

std::shared_ptr<const graph::Factor> NodeChain::factorOf(graph::Key before, graph::Key node,
                                                         const Link& link) const {
  const Eigen::Matrix3d P = link.covariance + ofSecondOrder(link);
  const auto W = graph::weightOfCovariance(twistCovariance(link.motion.increment, P));
  if (link.motion.J.isZero(0.0))
    return std::make_shared<graph::Between>(before, node, link.motion.increment, W);
  return std::make_shared<graph::CalibratedBetween>(before, node, wheels_, link.motion, W);
}

NodeChain::Link NodeChain::renewed(Link link) const {
  if (wheels_.empty()) return link;
  const Pose2 first = graph_.pose(wheels_[0]), second = graph_.pose(wheels_[1]);
  const Eigen::Vector3d now(first.x(), first.y(), second.x());
  const Eigen::DiagonalMatrix<double, 3> growth(link.motion.growth(now));
  if (!link.motion.J.isZero(0.0)) link.covariance = growth * link.covariance * growth;
  link.motion.increment = link.motion.with(now);
  link.motion.at = now;
  return link;
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
  link.covariance += coordinateCovariance(link.motion.increment, more);
  join(node.before, key, link);
}

void NodeChain::remove(graph::Key key) {
  removeChords(key);
  const Node node = nodes_.at(key);
  cut(key);
  if (node.after >= 0) {
    const Link next = nodes_.at(node.after).link;
    cut(node.after);
    if (node.before >= 0)
      join(node.before, node.after, composed(renewed(node.link), renewed(next)));
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

}  // namespace slam::landmark_graph
