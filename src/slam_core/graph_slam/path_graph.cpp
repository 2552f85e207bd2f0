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

Eigen::Matrix3d twistCovariance(const Pose2& pose, const Eigen::Matrix3d& of_coordinates) {
  constexpr double kSmallestSigma = 1e-6;  // [m], [rad]
  const Eigen::Matrix3d J_inverse = pose.twistJacobian().transpose();
  return J_inverse * of_coordinates * J_inverse.transpose() +
         kSmallestSigma * kSmallestSigma * Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d coordinateCovariance(const Pose2& pose, const Eigen::Matrix3d& of_twist) {
  const Eigen::Matrix3d J = pose.twistJacobian();
  return symmetric(J * of_twist * J.transpose());
}

PoseEstimate PathGraph::robot() const {
  PoseEstimate from = start_;
  if (node_) {
    from.pose = graph_.pose(*node_);
    from.covariance = coordinateCovariance(from.pose, graph_.covariance({*node_}));
  }
  if (!motion_) return from;
  Eigen::Matrix3d J_from, J_motion;
  const Pose2 pose = from.pose.compose(motion_->increment, &J_from, &J_motion);
  return {pose, symmetric(J_from * from.covariance * J_from.transpose() +
                          J_motion * motion_->covariance * J_motion.transpose())};
}

Eigen::MatrixXd PathGraph::covariance(const std::vector<graph::Key>& keys) const {
  std::vector<graph::Key> all;
  if (node_) all.push_back(*node_);
  all.insert(all.end(), keys.begin(), keys.end());
  const Eigen::MatrixXd known = graph_.covariance(all);
  const auto size = known.rows() + (node_ ? 0 : 3);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(size, size);
  P.bottomRightCorner(known.rows(), known.cols()) = known;
  if (!node_) P.topLeftCorner<3, 3>() = twistCovariance(start_.pose, start_.covariance);
  if (!motion_) return P;
  const Eigen::Matrix3d Ad = motion_->increment.inverse().adjoint();
  P.topRows<3>() = Ad * P.topRows<3>().eval();
  P.leftCols<3>() = P.leftCols<3>().eval() * Ad.transpose();
  P.topLeftCorner<3, 3>() += twistCovariance(motion_->increment, motion_->covariance);
  return P;
}

PosePrediction PathGraph::predict(const Motion& motion) {
  PosePrediction prediction;
  Eigen::Matrix3d J_motion;
  robot().pose.compose(motion.increment, &prediction.F, &J_motion);
  prediction.Q = J_motion * motion.covariance * J_motion.transpose();
  motion_ = motion_ ? joined(*motion_, motion) : motion;
  return prediction;
}

void PathGraph::correct(const Pose2& increment, const Eigen::Matrix3d& covariance) {
  if (!motion_) motion_.emplace();
  motion_->increment = increment;
  motion_->covariance = covariance;
}

void PathGraph::relocate(const PoseEstimate& robot) {
  start_ = robot;
  node_.reset();
  motion_.reset();
}

void PathGraph::startAt(graph::Key node) {
  node_ = node;
  ++nodes_;
}

graph::Key PathGraph::nodeNearby() {
  const auto is_far = [this](const Pose2& moved) {
    return moved.position().norm() > limits_.distance || std::abs(moved.theta()) > limits_.angle;
  };
  if (node_ && !(motion_ && is_far(motion_->increment))) return *node_;
  return addNode();
}

graph::Key PathGraph::addNode() {
  const auto now = robot();
  const auto key = graph_.add(now.pose);
  if (!node_) {
    const auto W = graph::weightOfCovariance(twistCovariance(now.pose, now.covariance));
    graph_.add(std::make_unique<graph::PosePrior>(key, now.pose, W));
  } else {
    const Motion motion = motion_.value_or(Motion());
    const auto W = graph::weightOfCovariance(twistCovariance(motion.increment, motion.covariance));
    graph_.add(std::make_unique<graph::Between>(*node_, key, motion.increment, W));
  }
  node_ = key;
  ++nodes_;
  motion_.reset();
  return key;
}

void PathGraph::optimize(int most_iterations) {
  std::vector<graph::Key> last;
  if (node_) last.push_back(*node_);
  for (int i = 0; i < most_iterations; ++i)
    if (!graph_.update(last)) return;
}

void PathGraph::mark(Stamp stamp) {
  const Pose2 moved = motion_ ? motion_->increment : Pose2();
  marks_.push_back({stamp, node_.value_or(-1), node_ ? moved : start_.pose * moved});
}

std::vector<StampedPose> PathGraph::path() const {
  std::vector<StampedPose> path;
  path.reserve(marks_.size());
  for (const auto& mark : marks_)
    path.push_back(
        {mark.stamp, mark.node < 0 ? mark.relative : graph_.pose(mark.node) * mark.relative});
  return path;
}

}  // namespace slam::graph_slam
