// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_slam.hpp"

#include <algorithm>
#include <string>

#include "slam_core/association/decision_record.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

// Symbols: x state, P its covariance, F Jacobian of the predicted robot by the robot before, Q
// covariance of the motion increment, J_before and J_u Jacobians of a composition by the first and
// the second pose, z observation, m landmark. Those of the update (W, dx) stand in
// observation_update.cpp.

namespace slam::ekf {
namespace {

const Registrar<Backend, EkfSlam> kRegistrar("ekf");
const SectionRegistrar<EkfConfig> kSectionRegistrar;
const SectionRegistrar<CalibrationConfig> kCalibrationSection;

/// The reference is renewed before an update where its effect is beyond this share of the
/// observations' sigmas.
constexpr double kLargestReferenceEffect = 0.1;

/// When this many observations at once are gated and none fits, they are no chance outliers.
constexpr std::size_t kLost = 3;

}  // namespace

void EkfSlam::configure(const EkfConfig& config) {
  validate(config);
  config_ = config;
  associator_ = Associator(config);
  variant_ = {makeLinearization(config.linearization), makeTransform(config.filter)};
  reset();
}

void EkfSlam::configure(Settings& settings) {
  auto config = settings.read<EkfConfig>();
  config.association = association_;
  config.calibration = settings.read<CalibrationConfig>();
  if (config.calibration.isOn() && config.mapIsFixed())
    throw ConfigError(
        "calibration.estimate: in a fixed map nothing is calibrated; use ekf.mode=slam, or leave "
        "the list empty");
  configure(config);
}

void EkfSlam::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", this).carrier();
  ports.takes<LandmarkObservationArray>("observations", "landmarks", this);
}

void EkfSlam::describe(Capabilities& capabilities) {
  capabilities.offer<LandmarkMapper>(*this);
  capabilities.offer<LandmarkRemover>(*this);
  capabilities.offer<MapKeeper>(*this);
  capabilities.offer<AssociationChooser>(*this);
  capabilities.offer<Calibrator>(*this);
}

void EkfSlam::reset() {
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  state_ =
      EkfState(variant_, limits(), {Pose2(), sigma.cwiseAbs2().asDiagonal()}, calibrationPrior());
  associator_.restart({});
  sightings_ = association::Sightings();
  statistics_ = {};
  counters_.clear();
  map_.reset();
  initial_pose_.reset();
  motion_.reset();
  velocity_.setZero();
  frame_ = SensorFrame();
  observations_.reset();
}

std::optional<CalibrationEstimate> EkfSlam::calibrationPrior() const {
  if (!config_.calibration.isOn()) return std::nullopt;
  return config_.calibration.prior();
}

void EkfSlam::set(const Motion& measured) {
  const auto parameters = state_.parameters();
  CalibrationJacobian<3> J(3, 0);
  const auto motion = parameters ? calibrated(measured, *parameters, &J) : measured;
  if (parameters) followVelocity(motion);
  if (!motion_) {
    motion_ = motion;
    J_motion_ = J;
    return;
  }
  Eigen::Matrix3d J_before, J_u;  // the compounding of Smith, Self, Cheeseman 1990
  motion_->increment = motion_->increment.compose(motion.increment, &J_before, &J_u);
  motion_->covariance = J_before * motion_->covariance * J_before.transpose() +
                        J_u * motion.covariance * J_u.transpose();
  J_motion_ = (J_before * J_motion_ + J_u * J).eval();
}

/// Low-pass filter of the velocity, of first order with a time constant of kWindow: the velocity of
/// a single message is mostly noise.
void EkfSlam::followVelocity(const Motion& motion) {
  constexpr double kWindow = 0.15;  // [s]
  const double interval = seconds(motion.end - motion.start);
  const Eigen::Vector3d now = motion.increment.log() / interval;
  velocity_ += std::min(1.0, interval / kWindow) * (now - velocity_);
}

/// Where parameters are calibrated, the state holds the sensor's pose instead of the robot's
/// (SensorFrame), and the observations get an identity mount.
LandmarkObservationArray EkfSlam::takeObservations() {
  auto array = *std::exchange(observations_, std::nullopt);
  if (const auto parameters = state_.parameters()) {
    move(frame_.look({array.sensor_pose, velocity_}, *parameters));
    array.sensor_pose = Pose2();
  }
  return array;
}

PoseEstimate EkfSlam::pose() const {
  const auto filtered = estimate();
  return {filtered.pose, variant_.transform->meanSquaredError(*variant_.linearization, filtered)};
}

/// The filter's own, whose covariance is that of the linearisation's error.
PoseEstimate EkfSlam::estimate() const {
  return state_.parameters() ? frame_.robot(state_.robotAndParameters()) : state_.pose();
}

LandmarkMap EkfSlam::landmarks() const {
  const bool has_own_unit = config_.calibration.estimates(kRangeScale);
  auto map = has_own_unit ? state().landmarks : state_.map();
  associator_.descriptors().describe(map);
  return map;
}

MapState EkfSlam::state() const {
  const bool has_joint = state_.inMap() <= static_cast<std::size_t>(config_.joint_limit);
  const auto parameters = state_.parameters();
  const bool needs_joint = has_joint || config_.calibration.estimates(kRangeScale);
  auto state = needs_joint ? state_.state() : MapState{estimate(), state_.map(), {}};
  if (parameters && needs_joint) state = frame_.map(state, *parameters);
  if (!has_joint) state.joint_covariance.resize(0, 0);
  associator_.descriptors().describe(state.landmarks);
  return state;
}

Status EkfSlam::execute() {
  statistics_ = {};
  statistics_.gate_probability = config_.gate_probability;
  if (map_ && config_.calibration.estimates(kRangeScale)) {
    map_.reset();
    return Status::error(
        "calibration.estimate: range_scale cannot be estimated in a map that is loaded, since that "
        "is in metres; leave it out of the list, or begin with an empty map");
  }
  replaceMap();
  relocate();
  predict();
  statistics_.landmarks = static_cast<int>(state_.inMap());
  if (!observations_) return Status::ok();
  const auto z = takeObservations();
  auto association = associator_.associate(z, state_, model_, counters_);
  const auto updated = update(association.matches, z.sensor_pose);
  const auto reconsidered = reconsider(association, z.sensor_pose);
  const auto augmented = augment(association, z.sensor_pose);
  removeGhosts(association, z.sensor_pose);
  statistics_.gated = static_cast<int>(association.gated.size());
  statistics_.log_likelihood += association.gated_log_likelihood;
  statistics_.unknown += association.unknown;
  statistics_.innovations = std::move(association.innovations);
  statistics_.associations = std::move(association.taken);
  statistics_.landmarks = static_cast<int>(state_.inMap());
  return summary(association, {updated, augmented, reconsidered});
}

Status EkfSlam::summary(const Association& association, const std::vector<Status>& of_steps) const {
  if (association.matches.empty() && association.gated.size() >= kLost)
    return Status::alarm("no observation fits the map, all are gated: the pose may be lost");
  if (config_.mapIsFixed() && state_.inMap() == 0)
    return Status::warning("there is no map to localise in; load one");
  const auto fault = std::find_if(of_steps.begin(), of_steps.end(),
                                  [](const Status& status) { return !status.isOk(); });
  return fault == of_steps.end() ? Status::ok() : *fault;
}

StretchLimits EkfSlam::limits() const {
  return {config_.neighbourhood, config_.update == UpdateExtent::kDense};
}

void EkfSlam::replaceMap() {
  if (!map_) return;
  const auto calibration = state_.calibration();
  frame_.forget();
  state_ = EkfState(variant_, limits(), *map_, config_.load_inflation, calibration);
  sightings_ = association::Sightings(map_->landmarks);
  associator_.restart(map_->landmarks);
  statistics_.prediction.F.setZero();
  map_.reset();
}

void EkfSlam::relocate() {
  if (!initial_pose_) return;
  const auto place = bounded(*initial_pose_, largestSigmas());
  if (const auto parameters = state_.parameters()) {
    frame_.forget();
    state_.relocate(inRangeUnits(place, *parameters));
    move(fromMetres(state_.robot()));
  } else {
    state_.relocate(place);
  }
  statistics_.prediction.F.setZero();
  initial_pose_.reset();
}

void EkfSlam::predict() {
  if (!motion_) return;
  const SensorFrame::Transition motion{motion_->increment, motion_->covariance, J_motion_};
  const auto parameters = state_.parameters();
  move(parameters ? frame_.moved(motion, *parameters) : motion);
  motion_.reset();
}

void EkfSlam::move(const SensorFrame::Transition& transition) {
  Motion motion;
  motion.increment = transition.increment;
  motion.covariance = transition.Q;
  associator_.move(motion);
  const auto [F, Q] = state_.predict(transition.increment, transition.Q, transition.J);
  auto& all = statistics_.prediction;
  all = {F * all.F, F * all.Q * F.transpose() + Q};
}

Status EkfSlam::update(const std::vector<Match>& matches, const Pose2& sensor) {
  if (matches.empty()) return Status::ok();
  const auto solved = [&] {
    return ObservationUpdate(model_, state_, sensor, matches, config_.iterations);
  };
  auto step = std::make_optional(solved());
  if (step->isSolved() && (variant_.linearization->isTooLarge(step->headingCorrection()) ||
                           step->referenceEffect() > kLargestReferenceEffect)) {
    state_.renewReference();
    step.emplace(solved());
  }
  if (!step->isSolved())
    return Status::error("the innovations' covariance is not positive definite; update left out");
  const auto W = step->gain();
  const Eigen::VectorXd dx = step->correction(W);
  if (!dx.allFinite() || !W.allFinite())
    return Status::error("the correction is not finite; update left out");

  statistics_.nis = step->nis();
  statistics_.nis_dof = 2 * static_cast<int>(matches.size());
  statistics_.used = static_cast<int>(matches.size());
  statistics_.log_likelihood += step->logLikelihood();
  statistics_.joint = step->joint();
  if (config_.mapIsFixed()) {
    state_.updateRobot(dx, W);
    return Status::ok();
  }
  state_.update(dx, W);
  for (const auto& match : matches) state_.extend(match.slot, sensor, match.z);
  return Status::ok();
}

Status EkfSlam::reconsider(const Association& association, const Pose2& sensor) {
  std::vector<LandmarkId> fitting;
  for (const auto& match : association.matches) fitting.push_back(match.z.id);
  auto told = Status::ok();
  for (const auto& verdict : sightings_.judge(fitting, association.gated))
    told = moreUrgent(reinitialize(verdict, sensor), told);
  return told;
}

Status EkfSlam::reinitialize(const association::Sightings::Verdict& verdict, const Pose2& sensor) {
  const auto m = initialized(verdict.z, sensor);
  if (!m.isFinite() || config_.mapIsFixed())
    return association::Sightings::warningOf(verdict, false);
  const auto id = verdict.z.id;
  sightings_.restart(id);
  if (associator_.distrusts(verdict)) {
    state_.retire(id);
    counters_.add("distrusted");
    return association::DistrustedIds::warningOf(id);
  }
  state_.beginAnew(id, m);
  counters_.add("begun_anew");
  return association::Sightings::warningOf(verdict, true);
}

Status EkfSlam::augment(Association& association, const Pose2& sensor) {
  auto status = Status::ok();
  association::NewLandmarks begun(association.taken);
  for (const auto& z : association.unseen) {
    begun.next();
    const auto m = initialized(z, sensor);
    if (!m.isFinite()) {
      counters_.add("not_finite");
      status = Status::error("landmark " + std::to_string(z.id) +
                             " would lie at a place that is not finite; it is left out");
      continue;
    }
    const bool is_named = z.id != kUnknownId && !state_.find(z.id);
    const auto id = is_named ? z.id : state_.freeId();
    state_.append(id, m);
    associator_.begin(id, z);
    begun.setId(id);
    ++statistics_.added;
  }
  return status;
}

void EkfSlam::removeGhosts(const Association& association, const Pose2& sensor) {
  for (const auto id : associator_.ghosts(association, state_, sensor)) {
    state_.retire(id);
    counters_.add("ghost");
  }
}

Status EkfSlam::remove(LandmarkId id) {
  const auto removal = removalOf(id, state_.find(id).has_value(), config_.mapIsFixed());
  if (!removal.isOk()) return removal;
  state_.retire(id);
  sightings_.restart(id);
  associator_.forget(id);
  counters_.add("removed");
  return removal;
}

NewLandmark EkfSlam::initialized(const LandmarkObservation& z, const Pose2& sensor) const {
  const auto& robot = state_.robot();
  std::optional<LineModel> line;
  if (z.isLine()) line.emplace(robot * sensor, z);
  const auto& of_kind = line ? static_cast<const ObservationModel&>(*line) : model_;
  NewLandmark m;
  Eigen::Matrix2d J_z;
  m.m_map = of_kind.invert(robot, sensor, z.vector(), &m.J_robot, &J_z);
  if (line) m.line = MappedLine{*line, line->extentOf(robot * sensor, z, m.m_map)};
  m.R = J_z * z.covariance * J_z.transpose();
  return m;
}

void EkfSlam::saveState(ArchiveWriter& archive) const { archive(*this); }

void EkfSlam::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::ekf
