// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/path_graph.hpp"

#include <cmath>
#include <memory>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/graph/factors.hpp"

// Symbols: a twist of the robot is a small motion in its own frame, J takes it to the coordinates
// (x, y, theta); P a covariance.

namespace slam::graph_slam {

PoseEstimate PathGraph::robot(const std::optional<graph::Key>& at) const {
  PoseEstimate from = start_;
  if (const auto node = at ? at : tail_.node) {
    from.pose = graph_.pose(*node);
    from.covariance = coordinateCovariance(from.pose, graph_.covariance({*node}));
  }
  if (at || !tail_.motion) return from;
  Eigen::Matrix3d J_from, J_motion;
  const Pose2 pose = from.pose.compose(tail_.motion->increment, &J_from, &J_motion);
  return {pose, symmetric(J_from * from.covariance * J_from.transpose() +
                          J_motion * tail_.motion->covariance * J_motion.transpose())};
}

Eigen::MatrixXd PathGraph::covariance(const std::vector<graph::Key>& keys,
                                      const std::optional<graph::Key>& at) const {
  const auto node = at ? at : tail_.node;
  std::vector<graph::Key> all;
  if (node) all.push_back(*node);
  all.insert(all.end(), keys.begin(), keys.end());
  const Eigen::MatrixXd known = graph_.covariance(all);
  const auto size = known.rows() + (node ? 0 : 3);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(size, size);
  P.bottomRightCorner(known.rows(), known.cols()) = known;
  if (!node) P.topLeftCorner<3, 3>() = twistCovariance(start_.pose, start_.covariance);
  if (at || !tail_.motion) return P;
  const Eigen::Matrix3d Ad = tail_.motion->increment.inverse().adjoint();
  P.topRows<3>() = Ad * P.topRows<3>().eval();
  P.leftCols<3>() = P.leftCols<3>().eval() * Ad.transpose();
  P.topLeftCorner<3, 3>() += twistCovariance(tail_.motion->increment, tail_.motion->covariance);
  return P;
}

PosePrediction PathGraph::predict(const Motion& motion) {
  PosePrediction prediction;
  Eigen::Matrix3d J_motion;
  robot().pose.compose(motion.increment, &prediction.F, &J_motion);
  prediction.Q = J_motion * motion.covariance * J_motion.transpose();
  tail_.motion = tail_.motion ? joined(*tail_.motion, motion) : motion;
  return prediction;
}

void PathGraph::correct(const Pose2& increment, const Eigen::Matrix3d& covariance) {
  if (!tail_.motion) tail_.motion.emplace();
  tail_.motion->increment = increment;
  tail_.motion->covariance = covariance;
}

void PathGraph::relocate(const PoseEstimate& robot) {
  start_ = robot;
  tail_.node.reset();
  tail_.motion.reset();
}

void PathGraph::relocate(graph::Key node) {
  tail_.node = node;
  tail_.motion.reset();
  ++tail_.nodes;
  chain_.start(node);
}

graph::Key PathGraph::nodeNearby() {
  const auto is_far = [this](const Pose2& moved) {
    return moved.position().norm() > limits_.distance || std::abs(moved.theta()) > limits_.angle;
  };
  if (tail_.node && !(tail_.motion && is_far(tail_.motion->increment))) return *tail_.node;
  return addNode();
}

graph::Key PathGraph::addNode() {
  const auto now = robot();
  const auto key = graph_.add(now.pose);
  if (!tail_.node) {
    const auto W = graph::weightOfCovariance(twistCovariance(now.pose, now.covariance));
    graph_.add(std::make_unique<graph::PosePrior>(key, now.pose, W));
    chain_.start(key);
  } else {
    chain_.append(*tail_.node, key, tail_.motion.value_or(Motion()));
  }
  tail_.node = key;
  ++tail_.nodes;
  tail_.motion.reset();
  return key;
}

void PathGraph::optimize(int most_iterations) {
  std::vector<graph::Key> last;
  if (tail_.node) last.push_back(*tail_.node);
  for (int i = 0; i < most_iterations; ++i)
    if (!graph_.update(last)) return;
}

}  // namespace slam::graph_slam
