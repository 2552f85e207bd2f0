// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/graph_slam/landmark_graph.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::graph_slam {

/// What the graph predicts of some observations of its landmarks: their innovations with the joint
/// covariance, before they are added to the graph.
class Prediction {
 public:
  Prediction(const LandmarkGraph& graph, const Pose2& sensor, const std::vector<Match>& matches);

  /// Whether the landmark lies in the sensor, so that the prediction of this match means nothing.
  bool isSingular(std::size_t match) const { return is_singular_[match] != 0; }
  Eigen::Vector2d innovation(std::size_t match) const { return nu_.segment<2>(row(match)); }
  Eigen::Matrix2d covariance(std::size_t match) const {
    return S_.block<2, 2>(row(match), row(match));
  }
  Eigen::Matrix2d crossCovariance(std::size_t a, std::size_t b) const {
    return S_.block<2, 2>(row(a), row(b));
  }
  /// The normalised innovation squared of a match. Where it is linearised again at the robot and
  /// landmark that explain the observation best (Bell and Cathey 1993): what remains of it.
  double nis(std::size_t match, int linearizations) const;
  /// Adds what these matches, used together, say to the statistics: as if linearised at the robot
  /// and landmarks that explain them all best, as the NIS of a match.
  /// @return whether their covariance is positive definite
  bool summarize(const std::vector<std::size_t>& used, UpdateStatistics& statistics) const;

 private:
  static Eigen::Index row(std::size_t match) { return 2 * static_cast<Eigen::Index>(match); }
  struct Linear {
    Eigen::Vector2d nu;
    Eigen::Matrix<double, 2, 5> H;  ///< by a twist of the robot and the landmark
  };
  Eigen::Vector2d placeInRobot(std::size_t match, const Eigen::Matrix<double, 5, 1>& correction,
                               Eigen::Matrix<double, 2, 5>& J) const;
  Linear linearized(std::size_t match, const Eigen::Matrix<double, 5, 1>& correction) const;

  /// Some matches together.
  struct Joint {
    Eigen::VectorXd nu;
    Eigen::MatrixXd H, R, S;  ///< H by the rows of P
    Eigen::LLT<Eigen::MatrixXd> L;
  };
  Joint linearized(const std::vector<std::size_t>& used, const Eigen::VectorXd& correction) const;
  bool solve(Joint& joint) const;
  Joint iterated(const std::vector<std::size_t>& used, Joint joint) const;

  Pose2 robot_, sensor_;
  const std::vector<Match>& matches_;
  std::vector<Eigen::Vector2d> points_;  ///< by match
  std::vector<Eigen::Index> rows_;       ///< of each match's landmark in P
  std::vector<char> is_singular_;
  Eigen::MatrixXd P_;  ///< of the robot, as a twist, and the landmarks
  Eigen::VectorXd nu_;
  Eigen::MatrixXd H_, S_;
};

}  // namespace slam::graph_slam
