// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "toy_backend.hpp"

#include <Eigen/LU>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

// Symbols: x state, P its covariance, Q that of the motion, z observation and R its covariance,
// m landmark, nu innovation and S its covariance, H Jacobian of the observation, W gain.

namespace slam_toy {
namespace {

const slam::Registrar<slam::Backend, ToyBackend> kRegistrar("toy");
const slam::SectionRegistrar<ToyConfig> kSectionRegistrar;

}  // namespace

void ToyConfig::describe(slam::Fields& fields) {
  fields.add("mode", &mode, slam::backendModeNames(),
             "build the map, or keep a loaded one fixed and only localise in it");
  fields.add("gate", &gate, "an observation is left out whose normalised innovation is larger")
      .unit("1")
      .in(slam::Range::above(0));
  fields.add("initial_sigma", &initial_sigma, "standard deviation of the first pose")
      .unit("m, rad")
      .in(slam::Range::above(0));
}

void ToyBackend::configure(slam::Settings& settings) {
  config_ = settings.read<ToyConfig>();
  reset();
}

void ToyBackend::describe(slam::Ports& ports) {
  ports.takes<slam::Motion>("motion", "motion", this).carrier();
  ports.takes<slam::LandmarkObservationArray>("observations", "landmarks", this);
}

void ToyBackend::describe(slam::Capabilities& capabilities) {
  capabilities.offer<slam::LandmarkMapper>(*this);
  capabilities.offer<slam::MapKeeper>(*this);
}

void ToyBackend::reset() {
  const double variance = config_.initial_sigma * config_.initial_sigma;
  x_ = Eigen::Vector3d::Zero();
  P_ = variance * Eigen::Matrix3d::Identity();
  at_.clear();
  statistics_ = {};
  counters_.clear();
  map_.reset();
  initial_pose_.reset();
  motions_.clear();
  observations_.reset();
}

slam::Status ToyBackend::execute() {
  statistics_ = {};
  if (map_) replaceMap(*std::exchange(map_, std::nullopt));
  if (initial_pose_) relocate(*std::exchange(initial_pose_, std::nullopt));
  for (const auto& motion : std::exchange(motions_, {})) predict(motion);
  if (observations_)
    for (const auto& z : observations_->observations) take(z, observations_->sensor_pose);
  observations_.reset();
  statistics_.landmarks = static_cast<int>(at_.size());
  return slam::Status::ok();
}

void ToyBackend::replaceMap(const slam::MapState& map) {
  x_ = map.robot.pose.vector();
  P_ = map.robot.covariance;
  at_.clear();
  for (const auto& landmark : map.landmarks) {
    append(landmark.id, landmark.position);
    P_.bottomRightCorner<2, 2>() = landmark.covariance;
  }
}

void ToyBackend::relocate(const slam::PoseEstimate& estimate) {
  x_.head<3>() = estimate.pose.vector();
  P_.topRows<3>().setZero();
  P_.leftCols<3>().setZero();
  P_.topLeftCorner<3, 3>() = estimate.covariance;
}

void ToyBackend::predict(const slam::Motion& motion) {
  Eigen::Matrix3d J_x, J_u;
  x_.head<3>() = robot().compose(motion.increment, &J_x, &J_u).vector();
  P_.topRows<3>() = (J_x * P_.topRows<3>()).eval();
  P_.leftCols<3>() = (P_.leftCols<3>() * J_x.transpose()).eval();
  P_.topLeftCorner<3, 3>() += J_u * motion.covariance * J_u.transpose();
}

void ToyBackend::take(const slam::LandmarkObservation& z, const slam::Pose2& sensor) {
  const auto known = at_.find(z.id);
  if (known != at_.end()) {
    correct(z, sensor, known->second);
  } else if (z.id == slam::kUnknownId || config_.mode == slam::BackendMode::kLocalization) {
    ++statistics_.unknown;
    counters_.add("unknown");
  } else {
    augment(z, sensor);
  }
}

void ToyBackend::correct(const slam::LandmarkObservation& z, const slam::Pose2& sensor,
                         Eigen::Index at) {
  Eigen::Matrix<double, 2, 3> J_robot;
  Eigen::Matrix2d J_m;
  const auto z_predicted = model_.predict(robot(), sensor, x_.segment<2>(at), &J_robot, &J_m);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2, x_.size());
  H.leftCols<3>() = J_robot;
  H.middleCols<2>(at) = J_m;
  const Eigen::Vector2d nu = model_.innovation(z.vector(), z_predicted);
  const Eigen::Matrix2d S = H * P_ * H.transpose() + z.covariance;
  const double nis = nu.dot(S.inverse() * nu);
  const bool used = nis < config_.gate && !model_.isSingular(z_predicted);
  statistics_.innovations.push_back({z.id, nu, S, z.covariance, used});
  if (!used) {
    ++statistics_.gated;
    counters_.add("gated");
    return;
  }
  Eigen::MatrixXd W = P_ * H.transpose() * S.inverse();
  if (config_.mode == slam::BackendMode::kLocalization) W.bottomRows(W.rows() - 3).setZero();
  x_ += W * nu;
  x_.head<3>() = robot().vector();  // the heading wrapped
  // (I - W H) P (I - W H)^T + W R W^T, which holds for every W
  const Eigen::MatrixXd WHP = W * (H * P_);
  P_ += W * S * W.transpose() - WHP - WHP.transpose();
  P_ = (0.5 * (P_ + P_.transpose())).eval();  // else what rounding adds grows
  ++statistics_.used;
  statistics_.nis += nis;
  statistics_.nis_dof += 2;
}

void ToyBackend::augment(const slam::LandmarkObservation& z, const slam::Pose2& sensor) {
  Eigen::Matrix<double, 2, 3> J_robot;
  Eigen::Matrix2d J_z;
  append(z.id, model_.invert(robot(), sensor, z.vector(), &J_robot, &J_z));
  const Eigen::MatrixXd cross = J_robot * P_.topRows<3>();
  P_.bottomRows<2>() = cross;
  P_.rightCols<2>() = cross.transpose();
  P_.bottomRightCorner<2, 2>() = J_robot * P_.topLeftCorner<3, 3>() * J_robot.transpose() +
                                 J_z * z.covariance * J_z.transpose();
  ++statistics_.added;
}

void ToyBackend::append(slam::LandmarkId id, const Eigen::Vector2d& m_map) {
  const auto size = x_.size();
  at_[id] = size;
  x_.conservativeResize(size + 2);
  x_.tail<2>() = m_map;
  P_.conservativeResizeLike(Eigen::MatrixXd::Zero(size + 2, size + 2));
}

slam::PoseEstimate ToyBackend::pose() const { return {robot(), P_.topLeftCorner<3, 3>()}; }

slam::LandmarkMap ToyBackend::landmarks() const {
  slam::LandmarkMap map;
  for (const auto& [id, at] : at_) map.push_back({id, x_.segment<2>(at), P_.block<2, 2>(at, at)});
  return map;
}

}  // namespace slam_toy
