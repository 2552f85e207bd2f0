// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/node_chain.hpp"

#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/twist_covariance.hpp"

namespace slam::graph_slam {

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
  const auto W = graph::weightOfCovariance(twistCovariance(link.increment, link.covariance));
  auto& joined = nodes_[node];
  joined.before = before;
  joined.link = link;
  joined.link.factor =
      graph_.add(std::make_unique<graph::Between>(before, node, link.increment, W));
  nodes_[before].after = node;
}

void NodeChain::remove(graph::Key key) {
  const Node node = nodes_.at(key);
  cut(key);
  if (node.after >= 0) {
    const Link next = nodes_.at(node.after).link;
    cut(node.after);
    if (node.before >= 0) {
      Eigen::Matrix3d J_first, J_second;
      Link both;
      both.increment = node.link.increment.compose(next.increment, &J_first, &J_second);
      both.covariance = J_first * node.link.covariance * J_first.transpose() +
                        J_second * next.covariance * J_second.transpose();
      both.way = node.link.way + next.way;
      both.is_composed = true;
      join(node.before, node.after, both);
    }
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

}  // namespace slam::graph_slam
