// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/gaussian_transform.hpp"

#include "slam_core/common/policy_table.hpp"
#include "slam_core/ekf/unscented_transform.hpp"

namespace slam::ekf {

RobotTransition TaylorTransform::predict(const Linearization& /*linearization*/,
                                         const PoseEstimate& robot, const Pose2& increment,
                                         const Eigen::Matrix3d& Q) const {
  RobotTransition transition;
  auto& [F, Q_pose] = transition.error;
  transition.robot = robot.pose.compose(increment, &F, &transition.G);
  Q_pose = transition.G * Q * transition.G.transpose();
  return transition;
}

namespace {

const PolicyTable<GaussianTransform>& transformTable() {
  static const PolicyTable<GaussianTransform> kTable(
      {{"extended", makePolicyOf<GaussianTransform, TaylorTransform>},
       {"unscented", makePolicyOf<GaussianTransform, UnscentedTransform>}});
  return kTable;
}

}  // namespace

const std::vector<std::string>& transformNames() { return transformTable().names(); }

std::unique_ptr<GaussianTransform> makeTransform(const std::string& name) {
  return transformTable().make(name);
}

}  // namespace slam::ekf
