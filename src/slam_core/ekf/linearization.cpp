// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/linearization.hpp"

namespace slam::ekf {

void TextbookLinearization::motionJacobians(const Pose2& robot, const Pose2& increment,
                                            Eigen::Matrix3d& F, Eigen::Matrix3d& G) const {
  robot.compose(increment, &F, &G);
}

Innovation TextbookLinearization::innovation(const ObservationModel& model, const Pose2& robot,
                                             const Pose2& sensor, const Eigen::Vector2d& m_map,
                                             const LandmarkObservation& z) const {
  Innovation innovation;
  const Eigen::Vector2d z_predicted =
      model.predict(robot, sensor, m_map, &innovation.H_robot, &innovation.H_landmark);
  innovation.nu = model.innovation(z.vector(), z_predicted);
  innovation.R = z.covariance;
  return innovation;
}

const std::vector<std::string>& linearizationNames() {
  static const std::vector<std::string> kNames = {"textbook"};
  return kNames;
}

std::unique_ptr<Linearization> makeLinearization(const std::string&) {
  return std::make_unique<TextbookLinearization>();
}

}  // namespace slam::ekf
