// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/seif_slam.hpp"

#include <string>
#include <utility>

#include "slam_core/association/decision_record.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::seif {
namespace {

const Registrar<Backend, SeifSlam> kRegistrar("seif");
const SectionRegistrar<SeifConfig> kSectionRegistrar;

std::size_t count(int number) { return static_cast<std::size_t>(number); }

/// Changes far from the robot may wait, so that a step hardly depends on the size of the map.
graph::OptimizerLimits optimizerLimits() {
  graph::OptimizerLimits limits;
  limits.passed_on = 25000;
  limits.patience = 2.0;
  return limits;
}

}  // namespace

SeifSlam::Filter::Filter(const SeifConfig& config, const PoseEstimate& start)
    : path({config.node_distance, config.node_angle}, start, optimizerLimits()),
      maps({count(config.active_landmarks + config.active_landmarks / 2), config.interval_heading},
           path, landmarks),
      interval(
          {count(config.active_landmarks), count(config.interval_nodes), config.interval_heading},
          path, landmarks, maps),
      surroundings(3 * count(config.active_landmarks), path, landmarks, maps) {}

void SeifSlam::configure(const SeifConfig& config) {
  validate(config);
  config_ = config;
  associator_ = landmark_graph::Associator(config.ofAssociation());
  reset();
}

void SeifSlam::configure(Settings& settings) {
  auto config = settings.read<SeifConfig>();
  config.association = association_;
  configure(config);
}

void SeifSlam::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", this).carrier();
  ports.takes<LandmarkObservationArray>("observations", "landmarks", this);
}

void SeifSlam::describe(Capabilities& capabilities) {
  capabilities.offer<LandmarkMapper>(*this);
  capabilities.offer<LandmarkRemover>(*this);
  capabilities.offer<MapKeeper>(*this);
  capabilities.offer<AssociationChooser>(*this);
}

void SeifSlam::reset() {
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  filter_ =
      std::make_unique<Filter>(config_, PoseEstimate{Pose2(), sigma.cwiseAbs2().asDiagonal()});
  associator_.restart({});
  sightings_ = association::Sightings();
  statistics_ = {};
  counters_.clear();
  fixed_map_.clear();
  map_.reset();
  initial_pose_.reset();
  motion_.reset();
  observations_.reset();
}

void SeifSlam::set(const Motion& motion) { motion_ = motion_ ? joined(*motion_, motion) : motion; }

Component::Figures SeifSlam::figures() const {
  constexpr double kMegabyte = 1e6;
  const auto cost = filter_->path.graph().cost();
  return {{"local_maps", static_cast<double>(filter_->maps.size())},
          {"most_joined_landmarks", static_cast<double>(filter_->maps.largest())},
          {"factor_megabytes", static_cast<double>(cost.bytes) / kMegabyte},
          {"eliminated_rows", cost.eliminated_rows}};
}

LandmarkMap SeifSlam::landmarks() const {
  auto map = fixed_map_;
  if (!config_.mapIsFixed()) {
    map = filter_->landmarks.map();
    settle(map);
  }
  associator_.descriptors().describe(map);
  return map;
}

/// Puts landmarks where they are when changes that wait have come to them.
void SeifSlam::settle(LandmarkMap& map) const {
  const auto& landmarks = filter_->landmarks;
  const auto estimates = settled(filter_->path.graph());
  for (auto& landmark : map)
    if (const auto number = landmarks.ids().find(landmark.id))
      landmark.position = estimates[static_cast<std::size_t>(keyOf(landmarks, *number))].position();
}

MapState SeifSlam::state() const {
  if (config_.mapIsFixed() || filter_->landmarks.ids().inMap() > count(config_.joint_limit))
    return {pose(), landmarks(), {}};
  auto state = filter_->landmarks.state();
  settle(state.landmarks);
  associator_.descriptors().describe(state.landmarks);
  return state;
}

Status SeifSlam::execute() {
  statistics_ = {};
  statistics_.gate_probability = config_.gate_probability;
  replaceMap();
  relocate();
  predict();
  const auto status = takeObservations();
  marginalise();
  statistics_.landmarks = static_cast<int>(filter_->landmarks.ids().inMap());
  return status;
}

void SeifSlam::replaceMap() {
  if (!map_) return;
  const auto map = *std::exchange(map_, std::nullopt);
  filter_ = std::make_unique<Filter>(config_, map.robot);
  filter_->landmarks.load(map, config_.load_inflation);
  sightings_ = association::Sightings(map.landmarks);
  associator_.restart(map.landmarks);
  if (config_.mapIsFixed()) fixed_map_ = map.landmarks;
  statistics_.prediction.F.setZero();
}

void SeifSlam::relocate() {
  if (!initial_pose_) return;
  filter_->interval.endForGood();
  filter_->path.relocate(bounded(*std::exchange(initial_pose_, std::nullopt), largestSigmas()));
  statistics_.prediction.F.setZero();
}

void SeifSlam::predict() {
  if (!motion_) return;
  const auto motion = *std::exchange(motion_, std::nullopt);
  associator_.move(motion);
  const auto [F, Q] = filter_->path.predict(motion);
  statistics_.prediction = {F * statistics_.prediction.F, Q};
}

Status SeifSlam::takeObservations() {
  if (!observations_) return Status::ok();
  const auto z = *std::exchange(observations_, std::nullopt);
  marginalise();
  auto association = associator_.associate(z, filter_->landmarks, statistics_, counters_);
  if (association.is_solved) filter_->landmarks.observe(association.matches, z.sensor_pose);
  const auto reconsidered = reconsider(association, z.sensor_pose);
  const auto augmented = augment(association, z.sensor_pose);
  filter_->interval.follow();
  filter_->solve(config_.iterations);
  removeGhosts(association, z.sensor_pose);
  statistics_.associations = std::move(association.taken);
  const auto status =
      statusOf(association, filter_->path, filter_->landmarks, config_.mapIsFixed());
  return moreUrgent(status, moreUrgent(augmented, reconsidered));
}

void SeifSlam::marginalise() {
  if (filter_->interval.endWhereFull()) filter_->solve(config_.iterations);
}

Status SeifSlam::reconsider(const landmark_graph::Association& association, const Pose2& sensor) {
  auto told = Status::ok();
  for (const auto& verdict : judged(sightings_, association))
    told = moreUrgent(reinitialize(verdict, sensor), told);
  return told;
}

/// What was seen of it elsewhere stays in the filter, as that of a landmark that is in no map.
Status SeifSlam::reinitialize(const association::Sightings::Verdict& verdict, const Pose2& sensor) {
  if (config_.mapIsFixed()) return association::Sightings::warningOf(verdict, false);
  const auto& z = verdict.z;
  sightings_.restart(z.id);
  idsOf(filter_->landmarks).retire(z.id);
  if (associator_.distrusts(verdict)) {
    counters_.add("distrusted");
    return association::DistrustedIds::warningOf(z.id);
  }
  if (append(z.id, z, sensor)) counters_.add("begun_anew");
  return association::Sightings::warningOf(verdict, true);
}

/// @return whether it lies at a place that is finite
bool SeifSlam::append(LandmarkId id, const LandmarkObservation& z, const Pose2& sensor) {
  const auto place = RangeBearingModel().invert(pose().pose, sensor, z.vector());
  if (place.allFinite()) filter_->landmarks.append(id, place, z, sensor);
  return place.allFinite();
}

Status SeifSlam::augment(landmark_graph::Association& association, const Pose2& sensor) {
  auto status = Status::ok();
  association::NewLandmarks begun(association.taken);
  for (const auto& z : association.unseen) {
    begun.next();
    if (!append(z.id, z, sensor)) {
      counters_.add("not_finite");
      status = Status::error("landmark " + std::to_string(z.id) +
                             " would lie at a place that is not finite; it is left out");
      continue;
    }
    const auto& ids = filter_->landmarks.ids();
    const auto id = ids[ids.size() - 1];
    begun.setId(id);
    associator_.begin(id, z);
    ++statistics_.added;
  }
  return status;
}

void SeifSlam::removeGhosts(const landmark_graph::Association& association, const Pose2& sensor) {
  for (const auto id : associator_.ghosts(association, filter_->landmarks, sensor)) {
    idsOf(filter_->landmarks).retire(id);
    counters_.add("ghost");
  }
}

Status SeifSlam::remove(LandmarkId id) {
  auto& ids = idsOf(filter_->landmarks);
  const auto removal = removalOf(id, ids.find(id).has_value(), config_.mapIsFixed());
  if (!removal.isOk()) return removal;
  ids.retire(id);
  sightings_.restart(id);
  associator_.forget(id);
  counters_.add("removed");
  return removal;
}

void SeifSlam::saveState(ArchiveWriter& archive) const { archive(*this); }

void SeifSlam::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::seif
