// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/ekf/innovation.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::ekf {

/// Where the filter evaluates its Jacobians.
class Linearization {
 public:
  virtual ~Linearization() = default;

  /// F = dx'/dx and G = dx'/du of x' = x (+) u.
  virtual void motionJacobians(const Pose2& robot, const Pose2& increment, Eigen::Matrix3d& F,
                               Eigen::Matrix3d& G) const = 0;
  /// nu, R, H_robot and H_landmark of an observation of the landmark estimated at `m_map`.
  virtual Innovation innovation(const ObservationModel& model, const Pose2& robot,
                                const Pose2& sensor, const Eigen::Vector2d& m_map,
                                const LandmarkObservation& z) const = 0;
};

/// At the newest estimate (Thrun, Burgard, Fox 2005, ch. 10).
class TextbookLinearization final : public Linearization {
 public:
  void motionJacobians(const Pose2& robot, const Pose2& increment, Eigen::Matrix3d& F,
                       Eigen::Matrix3d& G) const override;
  Innovation innovation(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                        const Eigen::Vector2d& m_map, const LandmarkObservation& z) const override;
};

const std::vector<std::string>& linearizationNames();

/// `name` is one of linearizationNames().
std::unique_ptr<Linearization> makeLinearization(const std::string& name);

}  // namespace slam::ekf
