// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/ekf/dense_covariance.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::ekf {

/// The Gaussian over robot and map: x = (robot, landmarks in the order they were first seen) and
/// its covariance P, with the ids of the landmarks.
class EkfState {
 public:
  explicit EkfState(const PoseEstimate& robot = {});
  /// Landmarks without a joint covariance get their marginals times `inflation` squared.
  EkfState(const MapState& map, double inflation);

  const Pose2& robot() const { return robot_; }
  Eigen::Vector2d landmark(Eigen::Index i) const { return landmarks_[static_cast<std::size_t>(i)]; }
  std::optional<Eigen::Index> find(LandmarkId id) const;
  std::size_t landmarks() const { return ids_.size(); }

  DenseCovariance& covariance() { return P_; }
  const DenseCovariance& covariance() const { return P_; }

  void setRobot(const Pose2& robot) { robot_ = robot; }
  /// x <- x + dx; the whole state, or its robot part where dx has three rows.
  void add(const Eigen::VectorXd& dx);
  void append(LandmarkId id, const Eigen::Vector2d& m_map,
              const Eigen::Matrix<double, 2, 3>& J_m_robot, const Eigen::Matrix2d& R);

  PoseEstimate pose() const { return {robot_, P_.robot()}; }
  LandmarkMap map() const;  ///< sorted by id, with marginals
  MapState state() const;   ///< sorted by id, with the joint covariance

 private:
  std::vector<Eigen::Index> orderById() const;

  Pose2 robot_;
  std::vector<Eigen::Vector2d> landmarks_;
  std::vector<LandmarkId> ids_;
  std::unordered_map<LandmarkId, Eigen::Index> index_;  // looked up only, never iterated
  DenseCovariance P_;
};

}  // namespace slam::ekf
