// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_slam.hpp"

#include <Eigen/Cholesky>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

// Symbols: x state, P its covariance, u motion increment with covariance Q, z observation with
// covariance R, nu innovation with covariance S = L L^T, m landmark.

namespace slam::ekf {
namespace {

const Registrar<Backend, EkfSlam> kRegistrar("ekf");
const SectionRegistrar<EkfConfig> kSectionRegistrar;

/// So many gated ones at once, and none that fits, are no chance outliers.
constexpr int kLost = 3;

}  // namespace

void EkfSlam::configure(const EkfConfig& config) {
  validate(config);
  config_ = config;
  association_ = KnownIdAssociation(config.gate_probability);
  linearization_ = makeLinearization(config.linearization);
  reset();
}

void EkfSlam::configure(Settings& settings) { configure(settings.read<EkfConfig>()); }

void EkfSlam::reset() {
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  state_ = EkfState({Pose2(), sigma.cwiseAbs2().asDiagonal()});
  statistics_ = {};
  counters_.clear();
  map_.reset();
  initial_pose_.reset();
  motion_.reset();
  observations_.reset();
}

void EkfSlam::set(const Motion& motion) {
  if (!motion_) {
    motion_ = motion;
    return;
  }
  Eigen::Matrix3d J_before, J_u;
  motion_->increment = motion_->increment.compose(motion.increment, &J_before, &J_u);
  motion_->covariance = J_before * motion_->covariance * J_before.transpose() +
                        J_u * motion.covariance * J_u.transpose();
}

Status EkfSlam::execute() {
  statistics_ = {};
  replaceMap();
  relocate();
  predict();
  statistics_.landmarks = static_cast<int>(state_.landmarks());
  if (!observations_) return Status::ok();
  const auto z = *std::exchange(observations_, std::nullopt);
  const auto matches = association_.associate(z, state_, model_, *linearization_, counters_);
  statistics_.gated = matches.gated;
  statistics_.unknown = matches.unknown;
  const auto status = update(matches.innovations);
  augment(matches.unseen, z.sensor_pose);
  statistics_.landmarks = static_cast<int>(state_.landmarks());
  if (matches.innovations.empty() && matches.gated >= kLost)
    return Status::warning("no observation fits the map, all are gated: the pose may be lost");
  if (config_.mode == "localization" && state_.landmarks() == 0)
    return Status::warning("there is no map to localise in; load one");
  return status;
}

void EkfSlam::replaceMap() {
  if (!map_) return;
  state_ = EkfState(*map_, config_.load_inflation);
  map_.reset();
}

void EkfSlam::relocate() {
  if (!initial_pose_) return;
  state_.setRobot(initial_pose_->pose);
  state_.covariance().resetRobot(initial_pose_->covariance);
  initial_pose_.reset();
}

void EkfSlam::predict() {
  if (!motion_) return;
  Eigen::Matrix3d F, G;
  linearization_->motionJacobians(state_.robot(), motion_->increment, F, G);
  state_.setRobot(state_.robot() * motion_->increment);
  state_.covariance().predict(F, G * motion_->covariance * G.transpose());
  motion_.reset();
}

Status EkfSlam::update(const std::vector<Innovation>& innovations) {
  if (innovations.empty()) return Status::ok();
  auto& P = state_.covariance();
  Eigen::MatrixXd W = P.timesTransposed(innovations);  // P H^T
  const Eigen::Index size = W.cols();

  Eigen::MatrixXd S(size, size);
  Eigen::VectorXd nu(size);
  for (Eigen::Index i = 0; i < size; i += 2) {
    const auto& innovation = innovations[static_cast<std::size_t>(i / 2)];
    S.middleRows<2>(i) = innovation.H_robot * W.topRows<3>() +
                         innovation.H_landmark * W.middleRows<2>(3 + 2 * innovation.landmark);
    S.block<2, 2>(i, i) += innovation.R;
    nu.segment<2>(i) = innovation.nu;
  }
  const Eigen::LLT<Eigen::MatrixXd> L(S);
  if (L.info() != Eigen::Success)
    return Status::error("the innovations' covariance is not positive definite; update left out");

  L.matrixU().solveInPlace<Eigen::OnTheRight>(W);  // P H^T L^-T, so that K S K^T = W W^T
  L.matrixL().solveInPlace(nu);
  statistics_.nis = nu.squaredNorm();
  statistics_.nis_dof = static_cast<int>(size);
  statistics_.used = static_cast<int>(innovations.size());
  if (config_.mode == "localization") {
    state_.add(W.topRows<3>() * nu);
    P.subtractOuterProductOfRobot(W);
  } else {
    state_.add(W * nu);
    P.subtractOuterProduct(W);
  }
  return Status::ok();
}

void EkfSlam::augment(const std::vector<LandmarkObservation>& unseen, const Pose2& sensor) {
  if (config_.mode == "localization") {
    statistics_.unknown += static_cast<int>(unseen.size());
    counters_.add("not_in_map", unseen.size());
    return;
  }
  for (const auto& z : unseen) {
    Eigen::Matrix<double, 2, 3> J_m_robot;
    Eigen::Matrix2d J_m_z;
    const auto m_map = model_.invert(state_.robot(), sensor, z.vector(), &J_m_robot, &J_m_z);
    state_.append(z.id, m_map, J_m_robot, J_m_z * z.covariance * J_m_z.transpose());
    ++statistics_.added;
  }
}

}  // namespace slam::ekf
