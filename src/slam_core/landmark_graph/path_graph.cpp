// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/path_graph.hpp"

#include <cmath>
#include <memory>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/models/moved_pose.hpp"

// Symbols: a twist of the robot is a small motion in its own frame, J takes it to the coordinates
// (x, y, theta); P a covariance.

namespace slam::landmark_graph {

void calibrate(PathGraph& path, const CalibrationEstimate& prior) {
  path.parameters_.emplace(path.graph_, prior);
  path.chain_.calibrate(path.parameters_->ofWheels());
  eliminate(path.graph_, path.parameters_->keys());
  path.by_wheels_ = {};
  path.by_wheels_.at = calibrationOf(path).head<3>();
}

CalibrationVector calibrationOf(const PathGraph& path) {
  return path.parameters_ ? path.parameters_->values(path.graph_) : CalibrationVector::Zero();
}

PoseEstimate PathGraph::robot(const std::optional<graph::Key>& at) const {
  PoseEstimate from = start_;
  const auto node = at ? at : tail_.node;
  if (node) from.pose = graph_.pose(*node);
  if (parameters_ && !at && tail_.motion) {
    const Pose2 pose = from.pose * tail_.motion->increment;
    return {pose, coordinateCovariance(pose, covariance({}))};
  }
  if (node) from.covariance = coordinateCovariance(from.pose, graph_.covariance({*node}));
  if (at || !tail_.motion) return from;
  return moved(from, *tail_.motion);
}

Eigen::MatrixXd PathGraph::covariance(const std::vector<graph::Key>& keys,
                                      const std::optional<graph::Key>& at) const {
  const auto node = at ? at : tail_.node;
  const bool needs_parameters = parameters_ && !at && tail_.motion;
  std::vector<graph::Key> all;
  if (node) all.push_back(*node);
  if (needs_parameters)
    all.insert(all.end(), parameters_->keys().begin(), parameters_->keys().end());
  all.insert(all.end(), keys.begin(), keys.end());
  const Eigen::MatrixXd known = graph_.covariance(all);
  const auto size = known.rows() + (node ? 0 : 3);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(size, size);
  P.bottomRightCorner(known.rows(), known.cols()) = known;
  if (!node) P.topLeftCorner<3, 3>() = twistCovariance(start_.pose, start_.covariance);
  if (needs_parameters) return withTail(P);
  if (at || !tail_.motion) return P;
  const Eigen::Matrix3d Ad = tail_.motion->increment.inverse().adjoint();
  P.topRows<3>() = Ad * P.topRows<3>().eval();
  P.leftCols<3>() = P.leftCols<3>().eval() * Ad.transpose();
  P.topLeftCorner<3, 3>() += twistCovariance(tail_.motion->increment, tail_.motion->covariance);
  return P;
}

/// Takes the robot from the last node along the motion since then.
/// @param P of the last node, the parameters and other variables
/// @return of the robot and the other variables
Eigen::MatrixXd PathGraph::withTail(const Eigen::MatrixXd& P) const {
  const auto& [increment, J, at] = by_wheels_;
  const auto others = P.rows() - 3 - parameters_->rows();
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(3 + others, P.rows());
  T.topLeftCorner<3, 3>() = increment.inverse().adjoint();
  T.block<3, 3>(0, 3) = increment.twistJacobian().transpose() * J;
  T.bottomRightCorner(others, others).setIdentity();
  Eigen::MatrixXd result = T * P * T.transpose();
  result.topLeftCorner<3, 3>() += twistCovariance(increment, tail_.motion->covariance);
  return 0.5 * (result + result.transpose());
}

Eigen::Matrix3d tailCovarianceOf(const PathGraph& path) {
  const auto& motion = path.tail_.motion;
  if (!motion) return Eigen::Matrix3d::Zero();
  if (!path.parameters_) return motion->covariance;
  const Eigen::MatrixXd P = path.graph_.covariance(path.parameters_->ofWheels());
  const auto& J = path.by_wheels_.J;
  return motion->covariance + symmetric(J * P.topLeftCorner<3, 3>() * J.transpose());
}

PosePrediction PathGraph::predict(const Motion& motion, const Eigen::Matrix3d& J_wheels) {
  PosePrediction prediction;
  Eigen::Matrix3d J_motion;
  robot().pose.compose(motion.increment, &prediction.F, &J_motion);
  prediction.Q = J_motion * motion.covariance * J_motion.transpose();
  const Pose2 before = tail_.motion ? tail_.motion->increment : Pose2();
  tail_.motion = tail_.motion ? joined(*tail_.motion, motion) : motion;
  if (!parameters_) return prediction;
  Eigen::Matrix3d J_before, J_u;
  before.compose(motion.increment, &J_before, &J_u);
  by_wheels_.J = (J_before * by_wheels_.J + J_u * J_wheels).eval();
  by_wheels_.increment = tail_.motion->increment;
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
  renewTail();
}

void PathGraph::relocate(graph::Key node) {
  tail_.node = node;
  tail_.motion.reset();
  renewTail();
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
    chain_.append(*tail_.node, key, tail_.motion.value_or(Motion()), by_wheels_);
  }
  tail_.node = key;
  ++tail_.nodes;
  tail_.motion.reset();
  renewTail();
  return key;
}

void PathGraph::optimize(int most_iterations, const std::vector<graph::Key>& others,
                         graph::Vicinity vicinity) {
  std::vector<graph::Key> last = others;
  if (tail_.node) last.push_back(*tail_.node);
  if (parameters_) last.insert(last.end(), parameters_->keys().begin(), parameters_->keys().end());
  for (int i = 0; i < most_iterations; ++i) {
    if (!graph_.update(last, vicinity)) break;
    vicinity.gathered.clear();
  }
  renewTail();
}

/// The motion since the last node as it is with the parameters now.
void PathGraph::renewTail() {
  if (!parameters_) return;
  const Eigen::Vector3d now = calibrationOf(*this).head<3>();
  if (tail_.motion) {
    const Eigen::DiagonalMatrix<double, 3> growth(by_wheels_.growth(now));
    tail_.motion->increment = by_wheels_.with(now);
    tail_.motion->covariance = growth * tail_.motion->covariance * growth;
    by_wheels_.increment = tail_.motion->increment;
  } else {
    by_wheels_ = {};
  }
  by_wheels_.at = now;
}

}  // namespace slam::landmark_graph
