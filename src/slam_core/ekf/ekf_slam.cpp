// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_slam.hpp"

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

// Symbols: x state, P its covariance, Q that of the motion increment, z observation, m landmark;
// those of the update stand in observation_update.cpp.

namespace slam::ekf {
namespace {

const Registrar<Backend, EkfSlam> kRegistrar("ekf");
const SectionRegistrar<EkfConfig> kSectionRegistrar;

/// Of the observations' sigmas: beyond it the reference is renewed before an update.
constexpr double kLargestReferenceEffect = 0.1;

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
  state_ = EkfState(linearization_, limits(), {Pose2(), sigma.cwiseAbs2().asDiagonal()});
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

MapState EkfSlam::state() const {
  if (state_.landmarks() <= static_cast<std::size_t>(config_.joint_limit)) return state_.state();
  return {state_.pose(), state_.map(), {}};
}

Status EkfSlam::execute() {
  statistics_ = {};
  replaceMap();
  relocate();
  predict();
  statistics_.landmarks = static_cast<int>(state_.landmarks());
  if (!observations_) return Status::ok();
  const auto z = *std::exchange(observations_, std::nullopt);
  state_.take(z.observations);
  auto association = association_.associate(z, state_, model_, config_.iterations, counters_);
  const auto status = update(association.matches, z.sensor_pose);
  augment(association.unseen, z.sensor_pose);
  statistics_.gated = association.gated;
  statistics_.log_likelihood += association.gated_log_likelihood;
  statistics_.unknown += association.unknown;
  statistics_.innovations = std::move(association.innovations);
  statistics_.landmarks = static_cast<int>(state_.landmarks());
  if (association.matches.empty() && association.gated >= kLost)
    return Status::warning("no observation fits the map, all are gated: the pose may be lost");
  if (config_.mode == "localization" && state_.landmarks() == 0)
    return Status::warning("there is no map to localise in; load one");
  return status;
}

StretchLimits EkfSlam::limits() const { return {config_.neighbourhood, config_.update == "dense"}; }

void EkfSlam::replaceMap() {
  if (!map_) return;
  state_ = EkfState(linearization_, limits(), *map_, config_.load_inflation);
  map_.reset();
}

void EkfSlam::relocate() {
  if (!initial_pose_) return;
  state_.relocate(*initial_pose_);
  initial_pose_.reset();
}

void EkfSlam::predict() {
  if (!motion_) return;
  state_.predict(motion_->increment, motion_->covariance);
  motion_.reset();
}

Status EkfSlam::update(const std::vector<Match>& matches, const Pose2& sensor) {
  if (matches.empty()) return Status::ok();
  const auto solved = [&] {
    return ObservationUpdate(model_, state_, sensor, matches, config_.iterations);
  };
  auto step = std::make_optional(solved());
  if (step->isSolved() && (linearization_->isTooLarge(step->headingCorrection()) ||
                           step->referenceEffect() > kLargestReferenceEffect)) {
    state_.renewReference();
    step.emplace(solved());
  }
  if (!step->isSolved())
    return Status::error("the innovations' covariance is not positive definite; update left out");

  statistics_.nis = step->nis();
  statistics_.nis_dof = 2 * static_cast<int>(matches.size());
  statistics_.used = static_cast<int>(matches.size());
  statistics_.log_likelihood += step->logLikelihood();
  statistics_.joint = step->joint();
  const auto W = step->gain();
  if (config_.mode == "localization")
    state_.updateRobot(step->correction(W), W);
  else
    state_.update(step->correction(W), W);
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
