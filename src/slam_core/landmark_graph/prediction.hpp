// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::landmark_graph {

/// What the graph predicts of some observations of its landmarks: their innovations with the joint
/// covariance, before they are added to the graph.
class Prediction {
 public:
  /// @param sensor on the robot @param matches outlives this
  Prediction(const LandmarkGraph& graph, const Pose2& sensor, const std::vector<Match>& matches,
             const Viewpoint& from = {});

  /// Whether the landmark lies in the sensor, so that the prediction of this match means nothing.
  bool isSingular(std::size_t match) const { return is_singular_[match] != 0; }
  Eigen::Vector2d innovation(std::size_t match) const { return linear_[match].nu; }
  Eigen::Matrix2d covariance(std::size_t match) const {
    return crossCovariance(match, match) + matches_[match].z.covariance;
  }
  /// How the errors of robot and landmarks correlate two predictions; without observation noise.
  Eigen::Matrix2d crossCovariance(std::size_t a, std::size_t b) const {
    return crossCovariance(a, linear_[a].H, b, linear_[b].H);
  }
  /// The normalised innovation squared of a match. Where it is linearised again at the robot and
  /// landmark that explain the observation best (Bell and Cathey 1993): what remains of it.
  double nis(std::size_t match, int linearizations) const;
  /// Adds what these matches, used together, say to the statistics: as if linearised at the robot
  /// and landmarks that explain them all best, as the NIS of a match.
  /// @return whether their covariance is positive definite
  bool summarize(const std::vector<std::size_t>& used, UpdateStatistics& statistics) const;

 private:
  using Jacobian = Eigen::Matrix<double, 2, 5>;  ///< by a twist of the robot and the landmark

  static Eigen::Index row(std::size_t match) { return 2 * static_cast<Eigen::Index>(match); }
  struct Linear {
    Eigen::Vector2d nu = Eigen::Vector2d::Zero();
    Jacobian H = Jacobian::Zero();
  };
  Eigen::Vector2d placeInRobot(std::size_t match, const Eigen::Matrix<double, 5, 1>& correction,
                               Jacobian& J) const;
  Linear linearized(std::size_t match, const Eigen::Matrix<double, 5, 1>& correction) const;
  Eigen::Matrix2d crossCovariance(std::size_t a, const Jacobian& H_a, std::size_t b,
                                  const Jacobian& H_b) const;

  /// Some matches together.
  struct Joint {
    Eigen::VectorXd nu;
    std::vector<Jacobian> H;  ///< by match
    Eigen::MatrixXd S;
    Eigen::LLT<Eigen::MatrixXd> L;
  };
  using Used = std::vector<std::size_t>;
  Joint linearized(const Used& used, const Eigen::VectorXd& correction) const;
  bool solve(const Used& used, Joint& joint) const;
  Eigen::VectorXd correctionOf(const Used& used, const Joint& joint) const;
  double curvature(const Used& used, const Joint& joint, const Joint& next,
                   const Eigen::VectorXd& correction) const;
  Joint iterated(const Used& used, Joint joint) const;
  JointInnovation tellable(const Used& used, const Joint& joint) const;

  Pose2 robot_, sensor_;  ///< where parameters are estimated the sensor takes the robot's place
  Eigen::Matrix3d of_robot_ = Eigen::Matrix3d::Identity();  ///< robot_'s twist by the robot's
  Eigen::Matrix3d J_robot_;                                 ///< the robot's twist by (x, y, theta)
  const std::vector<Match>& matches_;
  std::vector<Eigen::Vector2d> points_;  ///< by match
  std::vector<Eigen::Index> rows_;       ///< of each match's landmark in P
  std::vector<char> is_singular_;
  std::vector<Linear> linear_;  ///< by match; zero where it is singular
  Eigen::MatrixXd P_;           ///< of the robot, as a twist, and the landmarks
};

}  // namespace slam::landmark_graph
