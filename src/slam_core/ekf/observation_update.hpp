// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/ekf/ekf_state.hpp"

namespace slam::ekf {

/// An observation of a landmark of the neighbourhood.
struct Match {
  Eigen::Index slot = 0;
  LandmarkObservation z;
};

/// The joint update with observations of one stamp, so far as it can be had from the observed
/// landmarks alone: iterated (Bell and Cathey 1993) until the observations are linear in the
/// correction, then ready to be applied to the whole neighbourhood.
class ObservationUpdate {
 public:
  /// @param linearizations at most so many; 1 is the plain EKF
  ObservationUpdate(const ObservationModel& model, const EkfState& state, const Pose2& sensor,
                    const std::vector<Match>& matches, int linearizations);

  /// Whether S is positive definite; nothing else holds where it is not.
  bool isSolved() const { return is_solved_; }
  /// Normalised innovation squared; over the iterations, what remains of it.
  double nis() const { return whitened_.squaredNorm(); }
  /// log N(nu; 0, S)
  double logLikelihood() const;
  /// The innovation of one match as if linearised at the prediction, and its covariance.
  Eigen::Vector2d innovation(std::size_t match) const;
  const Eigen::Matrix2d& covariance(std::size_t match) const { return S_diagonal_[match]; }
  /// Of the first matches, UpdateStatistics::kJoint at most.
  JointInnovation joint() const;
  double headingCorrection() const { return dx_(2); }
  /// What it is worth in sigmas of the observations, at most, that landmarks turn with the
  /// reference's heading instead of the robot's.
  double referenceEffect() const;

  /// W = P H^T L^-T of the whole neighbourhood, so that P - W W^T is the covariance afterwards
  /// and correction(W) the correction.
  Eigen::MatrixXd gain() const;
  Eigen::VectorXd correction(const Eigen::MatrixXd& W) const { return W * whitened_; }

 private:
  static constexpr Eigen::Index kHead = DenseCovariance::kHeadSize;

  void gather();
  void linearize(const ObservationModel& model, const Pose2& sensor);
  ObservedCovariance covarianceAround(std::size_t match) const;
  void solve();
  double nonlinearity(const ObservationModel& model, const Pose2& sensor) const;
  Eigen::VectorXd jacobianTimes(const Eigen::VectorXd& dx) const;
  Pose2 candidate() const;
  LandmarkPoint candidate(std::size_t match) const;

  const EkfState& state_;
  const std::vector<Match>& matches_;
  Eigen::MatrixXd P_;          ///< of (robot, reference, observed landmarks)
  Eigen::MatrixXd P_updated_;  ///< after the last iteration, about the candidate
  std::vector<Innovation> innovations_;
  std::vector<Eigen::Matrix2d> S_diagonal_;
  Eigen::VectorXd nu_;  ///< as if linearised at the prediction: nu + H dx
  Eigen::MatrixXd PHt_;
  Eigen::LLT<Eigen::MatrixXd> L_;
  Eigen::VectorXd whitened_;  ///< L^-1 nu
  Eigen::VectorXd dx_;        ///< rows as P_
  bool is_solved_ = false;
};

}  // namespace slam::ekf
