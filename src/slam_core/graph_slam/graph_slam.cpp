// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_slam.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::graph_slam {
namespace {

const Registrar<Backend, GraphSlam> kRegistrar("graph");
const SectionRegistrar<GraphConfig> kSectionRegistrar;

/// When this many observations at once are gated and none fits, they are no chance outliers.
constexpr std::size_t kLost = 3;

Eigen::Vector2d placeOf(const LandmarkObservation& z, const Pose2& robot, const Pose2& sensor) {
  return RangeBearingModel().invert(robot, sensor, z.vector());
}

}  // namespace

void GraphSlam::configure(const GraphConfig& config) {
  validate(config);
  config_ = config;
  associator_ = Associator(config);
  reset();
}

void GraphSlam::configure(Settings& settings) { configure(settings.read<GraphConfig>()); }

void GraphSlam::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", this).carrier();
  ports.takes<LandmarkObservationArray>("observations", "landmarks", this);
}

void GraphSlam::describe(Capabilities& capabilities) {
  capabilities.offer<LandmarkMapper>(*this);
  capabilities.offer<MapKeeper>(*this);
  capabilities.offer<PathReviser>(*this);
}

Component::Figures GraphSlam::figures() const {
  return {{"nodes", double(graph_.nodes())},
          {"factor_bytes", double(graph_.graph().tree().bytes())},
          {"eliminated_rows", double(graph_.graph().tree().eliminatedRows())}};
}

void GraphSlam::reset() {
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  graph_ = LandmarkGraph(nodeLimits(), {Pose2(), sigma.cwiseAbs2().asDiagonal()});
  sightings_ = association::Sightings();
  fixed_map_.clear();
  statistics_ = {};
  counters_.clear();
  map_.reset();
  initial_pose_.reset();
  motion_.reset();
  observations_.reset();
}

void GraphSlam::set(const Motion& motion) { motion_ = motion_ ? joined(*motion_, motion) : motion; }

LandmarkMap GraphSlam::landmarks() const {
  return config_.mapIsFixed() ? fixed_map_ : graph_.map();
}

MapState GraphSlam::state() const {
  if (config_.mapIsFixed() || graph_.landmarks() > static_cast<std::size_t>(config_.joint_limit))
    return {pose(), landmarks(), {}};
  return graph_.state();
}

Status GraphSlam::execute() {
  statistics_ = {};
  statistics_.gate_probability = config_.gate_probability;
  replaceMap();
  relocate();
  const Stamp moved_until = motion_ ? motion_->end : Stamp();
  predict();
  statistics_.landmarks = static_cast<int>(graph_.landmarks());
  if (!observations_) {
    if (moved_until != Stamp()) graph_.mark(moved_until);
    return Status::ok();
  }
  const auto z = *std::exchange(observations_, std::nullopt);
  const auto association = associator_.associate(z, graph_, statistics_, counters_);
  if (association.is_solved) graph_.observe(association.matches, z.sensor_pose);
  const auto reconsidered = reconsider(association, z.sensor_pose);
  const auto augmented = augment(association.unseen, z.sensor_pose);
  graph_.optimize(config_.iterations);
  graph_.mark(z.stamp);
  statistics_.landmarks = static_cast<int>(graph_.landmarks());
  return summary(association, {augmented, reconsidered});
}

Status GraphSlam::summary(const Association& association,
                          const std::vector<Status>& of_steps) const {
  if (association.matches.empty() && association.gated.size() >= kLost)
    return Status::alarm("no observation fits the map, all are gated: the pose may be lost");
  if (config_.mapIsFixed() && graph_.landmarks() == 0)
    return Status::warning("there is no map to localise in; load one");
  if (!association.is_solved)
    return Status::error("the innovations' covariance is not positive definite; update left out");
  const auto fault = std::find_if(of_steps.begin(), of_steps.end(),
                                  [](const Status& status) { return !status.isOk(); });
  return fault == of_steps.end() ? Status::ok() : *fault;
}

void GraphSlam::replaceMap() {
  if (!map_) return;
  graph_ = LandmarkGraph(nodeLimits(), *map_, config_.load_inflation);
  sightings_ = association::Sightings(map_->landmarks);
  if (config_.mapIsFixed()) fixed_map_ = map_->landmarks;
  statistics_.prediction.F.setZero();
  map_.reset();
}

void GraphSlam::relocate() {
  if (!initial_pose_) return;
  graph_.relocate(bounded(*initial_pose_, largestSigmas()));
  statistics_.prediction.F.setZero();
  initial_pose_.reset();
}

void GraphSlam::predict() {
  if (!motion_) return;
  const auto [F, Q] = graph_.predict(*motion_);
  statistics_.prediction = {F * statistics_.prediction.F, Q};
  motion_.reset();
}

Status GraphSlam::reconsider(const Association& association, const Pose2& sensor) {
  std::vector<LandmarkId> fitting;
  for (const auto& match : association.matches) fitting.push_back(match.z.id);
  std::vector<LandmarkObservation> gated;
  for (const auto& match : association.gated) gated.push_back(match.z);
  const auto verdict = sightings_.judge(fitting, gated);
  std::string ids;
  for (const auto& z : verdict.doubtful) {
    if (config_.mapIsFixed()) continue;
    graph_.reinitialize(*graph_.find(z.id), placeOf(z, pose().pose, sensor), z, sensor);
    counters_.add("begun_anew");
    ids += (ids.empty() ? "" : ", ") + std::to_string(z.id);
  }
  if (!ids.empty())
    return Status::warning("landmark " + ids +
                           " was hardly ever where the map had it: it is begun anew");
  if (verdict.times == 0) return Status::ok();
  return Status::warning("landmark " + std::to_string(verdict.moved) +
                         " was not where the map has it " + std::to_string(verdict.times) +
                         " times in a row: was it moved?");
}

Status GraphSlam::augment(const std::vector<LandmarkObservation>& unseen, const Pose2& sensor) {
  auto status = Status::ok();
  for (const auto& z : unseen) {
    const auto place = placeOf(z, pose().pose, sensor);
    if (!place.allFinite()) {
      counters_.add("not_finite");
      status = Status::error("landmark " + std::to_string(z.id) +
                             " would lie at a place that is not finite; it is left out");
      continue;
    }
    const bool is_named = z.id != kUnknownId && !graph_.find(z.id);
    graph_.append(is_named ? z.id : graph_.freeId(), place, z, sensor);
    ++statistics_.added;
  }
  return status;
}

}  // namespace slam::graph_slam
