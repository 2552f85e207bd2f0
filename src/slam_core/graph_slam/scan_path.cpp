// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_path.hpp"

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/motion_evidence.hpp"

namespace slam::graph_slam {
namespace {

void add(const Motion& motion, std::optional<Motion>& sum) {
  sum = sum ? joined(*sum, motion) : motion;
}

}  // namespace

void ScanPath::restart() {
  carried_.reset();
  last_.reset();
  reference_.reset();
}

void ScanPath::forget(graph::Key node) {
  if (reference_ && reference_->node == node) reference_ = last_;
  if (!last_ || last_->node != node) return;
  last_.reset();
  reference_.reset();
}

void ScanPath::predict(const Motion& motion) {
  add(motion, carried_);
  if (last_) add(motion, last_->told);
  if (reference_) add(motion, reference_->told);
}

/// It is the first node that scans find, or one to which no odometry leads.
void ScanPath::locate(const PoseEstimate& robot) {
  const auto& [node, since, count] = path_.tail();
  if (!node || (last_ && (carried_ || last_->node == *node))) return;
  Place place{*node, robot, since};
  if (carried_) place.in_odom.pose = place.in_odom.pose * carried_->increment;
  if (since) place.in_odom.pose = place.in_odom.pose * since->increment.inverse();
  last_ = reference_ = place;
}

bool ScanPath::follow(const PoseEstimate& robot, bool is_determined) {
  if (!last_) return false;
  if (path_.tail().node == last_->node) {
    const auto motion = motionFrom(*last_, robot);
    path_.correct(motion.pose, motion.covariance);
  } else if (is_determined) {
    join(robot);
  }
  return true;
}

graph::Key ScanPath::insert(const PoseEstimate& robot, const Eigen::Matrix3d& of_scan,
                            bool is_determined) {
  const auto& tail = path_.tail();
  if (is_determined && last_ && last_->node != reference_->node && last_->told && tail.motion)
    join(robot);
  else if (!tail.node || tail.motion)
    path_.addNode();
  last_ = reference_ = Place{*tail.node, {robot.pose, of_scan}, {}};
  reference_->in_odom.covariance.setZero();
  return last_->node;
}

PoseEstimate ScanPath::motionFrom(const Place& place, const PoseEstimate& robot) const {
  Eigen::Matrix3d J_inverse, J_to_place, J_robot;
  const Pose2 increment =
      place.in_odom.pose.inverse(&J_inverse).compose(robot.pose, &J_to_place, &J_robot);
  const Eigen::Matrix3d J_place = J_to_place * J_inverse;
  Eigen::Matrix3d P = J_place * place.in_odom.covariance * J_place.transpose() +
                      J_robot * robot.covariance * J_robot.transpose();
  P.diagonal() += increment.position().norm() * drift_;
  return {increment, symmetric(P)};
}

/// The scan's chord tells what odometry does not; a node at its stamp is its own. Where odometry
/// has slipped, the scan alone tells the motion.
void ScanPath::join(const PoseEstimate& robot) {
  const auto step = motionFrom(*reference_, robot);
  const auto told = reference_->told.value_or(Motion());
  if (path_.tail().node == last_->node)
    path_.correct(last_->told->increment, last_->told->covariance);
  const auto node = path_.tail().motion ? path_.addNode() : *path_.tail().node;
  const Eigen::Matrix3d P = twistCovariance(step.pose, step.covariance);
  Eigen::MatrixXd W;
  if (contradict({told.increment, told.covariance}, step)) {
    loosenLinks(node, told.increment.between(step.pose).log());
    W = graph::weightOfCovariance(P);
  } else {
    W = graph::weightOfInformation(
        informationBeyond(P, twistCovariance(told.increment, told.covariance)));
  }
  chainOf(path_).addChord(reference_->node, node, step.pose, W);
  last_ = Place{node, robot, {}};
  path_.optimize(iterations_);
}

/// Each motion since the last scan may be the one that is off by the error.
void ScanPath::loosenLinks(graph::Key node, const Eigen::Vector3d& error) {
  auto& chain = chainOf(path_);
  for (; node >= 0 && node != last_->node; node = chain[node].before)
    chain.loosen(node, error * error.transpose());
}

}  // namespace slam::graph_slam
