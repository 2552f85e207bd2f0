// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/ekf/dense_covariance.hpp"
#include "slam_core/ekf/panel_triangle.hpp"

namespace slam::ekf {

/// The errors of robot and map as one Gaussian, of which a step works on the part around the robot
/// only: the compressed filter of Guivant and Nebot 2001. An interval is the time between two
/// global updates. At its start the robot's pose becomes the reference, and the covariance of
/// (reference, all landmarks) is the prior. A landmark is taken into the neighbourhood when it is
/// observed. Neither the reference nor a landmark moves: given the reference and the taken
/// landmarks, the other ones are conditionally independent of all that is measured in the interval.
/// So with
///   a: the reference and the taken landmarks, b: the other landmarks, 0: at the start,
///   L: the Cholesky factor of P_aa0 = L L^T, W = P_ba0 L^-T,
/// their covariance becomes
///   P_bb = P_bb0 - W (I - L^-1 P_aa L^-T) W^T,
/// which renew() writes into the prior: the global update. It also starts a new interval, with the
/// robot's pose as the reference. Calibrated parameters are the first landmarks; they must have
/// been taken before all others whenever a Jacobian by them is given.
class Neighbourhood {
 public:
  /// @param joint of (pose, landmarks), size 3 + 2 N
  explicit Neighbourhood(const Eigen::MatrixXd& joint = Eigen::Matrix3d::Identity());
  /// The landmarks are not correlated.
  Neighbourhood(const Eigen::Matrix3d& robot, const std::vector<Eigen::Matrix2d>& landmarks);

  Eigen::Index landmarks() const { return static_cast<Eigen::Index>(slots_.size()); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(taken_.size()); }
  /// Whether the robot is still at the reference: it was neither moved nor corrected.
  bool isFresh() const { return is_fresh_; }
  /// The landmark's place in the neighbourhood, or -1.
  Eigen::Index slot(Eigen::Index landmark) const {
    return slots_[static_cast<std::size_t>(landmark)];
  }
  const std::vector<Eigen::Index>& taken() const { return taken_; }
  /// The covariance of (robot, reference, taken landmarks).
  const DenseCovariance& covariance() const { return local_; }
  /// The sum of all corrections since the interval began, in the rows of covariance(); the robot's
  /// three rows are zero.
  const Eigen::VectorXd& correction() const { return correction_; }

  void take(Eigen::Index landmark);
  /// A new landmark, see DenseCovariance.
  void append(const DenseCovariance::Matrix23& J_m_robot, const Eigen::Matrix2d& R);
  void predict(const Eigen::Matrix3d& F, const Eigen::Matrix3d& Q,
               const CalibrationJacobian<3>& A = {});
  void transportRobot(const Eigen::Vector2d& c) { ekf::transportRobot(c, local_); }
  /// P <- P - W W^T after a correction dx = W y. This W is that of the update
  /// (ObservationUpdate::gain()): W = P H^T L^-T with S = L L^T, and y = L^-1 nu.
  void update(const Eigen::MatrixXd& W, const Eigen::VectorXd& dx);
  /// The same for the robot only.
  void updateRobot(const Eigen::MatrixXd& W);
  /// The robot is put elsewhere: its block is replaced, its correlations become zero.
  void resetRobot(const Eigen::Matrix3d& robot);

  /// Re-initialises a landmark in its place: it is marginalised and appended again. Right after
  /// renew() only.
  void replace(Eigen::Index landmark, const DenseCovariance::Matrix23& J_m_robot,
               const Eigen::Matrix2d& R);

  /// The corrections of all landmarks since the interval began, a column each.
  Eigen::Matrix2Xd allCorrections() const;
  /// The marginals of all landmarks, where the error e_m of each becomes e_m + c e_theta.
  /// e_theta is the error of the reference's heading [rad], c the landmark's column
  /// (Linearization::landmarkTransport).
  std::vector<Eigen::Matrix2d> marginals(const Eigen::Matrix2Xd& c) const;
  /// Upper bounds of the variances in marginals(), a column each, at a fraction of the cost: they
  /// leave out what the interval's updates have told of landmarks that were not taken.
  Eigen::Matrix2Xd varianceBounds(const Eigen::Matrix2Xd& c) const;
  /// The global update, after which nothing is taken; c as above.
  void renew(const Eigen::Matrix2Xd& c);
  /// The covariance of (reference, landmarks) when the interval began: right after renew() that of
  /// (robot, landmarks).
  double prior(Eigen::Index row, Eigen::Index column) const { return prior_(row, column); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(prior_, local_, correction_, taken_, slots_, known_, is_fresh_, is_updated_,
            prior_rows_, local_rows_, L_, factored_);
  }

 private:
  static constexpr Eigen::Index kPoseSize = 3;
  static Eigen::Index priorRow(Eigen::Index landmark) { return kPoseSize + 2 * landmark; }

  /// The taken part, whitened by L.
  struct Whitened {
    Eigen::MatrixXd cross;  ///< P_local,a L^-T
    Eigen::MatrixXd gain;   ///< I - L^-1 P_aa L^-T
  };
  Whitened whitened() const;
  std::vector<Eigen::Index> rest() const;
  /// The block P_ab0 of the prior, between the taken part and landmarks.
  Eigen::MatrixXd priorOf(const std::vector<Eigen::Index>& landmarks) const;
  Eigen::MatrixXd localColumns() const;  ///< P_local,a
  void extendFactor() const;
  Eigen::MatrixXd timesFactorInverse(Eigen::MatrixXd left) const;  ///< left L^-T
  Eigen::MatrixXd solvePrior(Eigen::MatrixXd right) const;         ///< P_aa0^-1 right
  /// W = P_ba0 L^-T of these landmarks; W gain W^T is subtracted from their covariance.
  Eigen::MatrixXd whitenedPrior(const std::vector<Eigen::Index>& landmarks) const;
  void updateRest(const std::vector<Eigen::Index>& rest, const Eigen::Matrix2Xd& c);
  void writeTaken(const Eigen::Matrix2Xd& c);
  void begin();

  PanelTriangle prior_;
  DenseCovariance local_;
  Eigen::VectorXd correction_;
  std::vector<Eigen::Index> taken_;  ///< landmarks by slot
  std::vector<Eigen::Index> slots_;  ///< slots by landmark
  Eigen::Index known_ = 0;           ///< landmarks that stand in the prior
  bool is_fresh_ = true;             ///< the robot was neither moved nor corrected
  bool is_updated_ = false;          ///< the taken part has been corrected

  // the taken part as far as it stands in the prior: rows there and in local_
  std::vector<Eigen::Index> prior_rows_, local_rows_;
  mutable Eigen::MatrixXd L_;  ///< factor of P_aa0, made when it is needed
  mutable Eigen::Index factored_ = 0;
};

}  // namespace slam::ekf
