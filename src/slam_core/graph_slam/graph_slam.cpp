// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_slam.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "slam_core/association/decision_record.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/graph_slam/graph_view.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::graph_slam {
namespace {

const Registrar<Backend, GraphSlam> kRegistrar("graph");
const SectionRegistrar<GraphConfig> kSectionRegistrar;
const SectionRegistrar<CalibrationConfig> kCalibrationSection;
const SectionRegistrar<grid_map::GridMapConfig> kGridMapRegistrar;
const SectionRegistrar<scan_matching::MatcherConfig> kMatcherRegistrar;

Eigen::Vector2d placeOf(const LandmarkObservation& z, const Pose2& robot, const Pose2& sensor) {
  return RangeBearingModel().invert(robot, sensor, z.vector());
}

}  // namespace

void GraphSlam::configure(const GraphConfig& config, const grid_map::GridMapConfig& grid,
                          const scan_matching::MatcherConfig& matcher) {
  FaultCollector faults;
  faults.attempt([&] { validate(config); });
  faults.attempt([&] { validate(grid); });
  faults.attempt([&] { validate(matcher); });
  faults.attempt([&] { checkCalibration(config); });
  faults.raise();
  config_ = config;
  grid_config_ = grid;
  matcher_config_ = matcher;
  associator_ = Associator(config.ofAssociation());
  reset();
}

void GraphSlam::configure(Settings& settings) {
  GraphConfig config;
  grid_map::GridMapConfig grid;
  scan_matching::MatcherConfig matcher;
  FaultCollector faults;
  faults.attempt([&] { settings.read(config); });
  config.association = association_;
  faults.attempt([&] { settings.read(config.calibration); });
  if (uses_grid_) {
    faults.attempt([&] { settings.read(grid); });
    faults.attempt([&] { settings.read(matcher); });
  }
  faults.raise();
  configure(config, grid, matcher);
}

void GraphSlam::describe(Ports& ports) {
  auto& motion = ports.takes<Motion>("motion", "motion", this).carrier();
  auto& observations = ports.takes<LandmarkObservationArray>("observations", "landmarks", this);
  if (!uses_grid_) return;
  motion.optional();
  observations.optional();
  ports.takes<LaserScan>("scan", "laser scans", this);
}

void GraphSlam::describe(Capabilities& capabilities) {
  capabilities.offer<LandmarkMapper>(*this);
  capabilities.offer<LandmarkRemover>(*this);
  if (uses_grid_) capabilities.offer<CorrectionReporter>(*this);
  if (uses_grid_) capabilities.offer<GridMapper>(*this);
  if (uses_grid_) capabilities.offer<LostReporter>(*this);
  capabilities.offer<EventReporter>(*this);
  capabilities.offer<GraphReporter>(*this);
  capabilities.offer<MapChooser>(*this);
  capabilities.offer<MapKeeper>(*this);
  capabilities.offer<SessionKeeper>(*this);
  capabilities.offer<SessionMerger>(*this);
  capabilities.offer<PathReviser>(*this);
  capabilities.offer<AssociationChooser>(*this);
  capabilities.offer<Calibrator>(*this);
}

Component::Figures GraphSlam::figures() const {
  constexpr double kMegabyte = 1e6;
  const auto cost = graph_->path.graph().cost();
  Figures figures = {
      {"nodes", static_cast<double>(graph_->path.tail().nodes - graph_->reduction.removed())},
      {"removed_nodes", static_cast<double>(graph_->reduction.removed())},
      {"factor_megabytes", static_cast<double>(cost.bytes) / kMegabyte},
      {"eliminated_rows", cost.eliminated_rows}};
  if (!graph_->scans) return figures;
  const auto& scans = *graph_->scans;
  figures.emplace_back("contradicting_ends", scans.doubt().agreement().contradictingShare());
  figures.emplace_back("lost_statistic", scans.doubt().statistic());
  figures.emplace_back("lost_for_s", seconds(scans.doubt().lostFor()));
  figures.emplace_back("loops", static_cast<double>(scans.loops().size()));
  figures.emplace_back("rejected_loops", static_cast<double>(scans.loops().rejected()));
  figures.emplace_back("map_megabytes", scans.mostBytes() / kMegabyte);
  return figures;
}

std::unique_ptr<GraphSlam::Graph> GraphSlam::emptyGraph(
    const PoseEstimate& start, const std::optional<CalibrationEstimate>& known) const {
  auto graph = std::make_unique<Graph>(config_, start);
  auto& delayed = graph->delayed;
  graph->reduction.announceTo([&delayed](graph::Key node) { delayed.forget(node); });
  if (config_.calibration.isOn())
    calibrate(graph->path, known.value_or(config_.calibration.prior()));
  if (!uses_grid_) return graph;
  auto& scans = graph->scans.emplace(graph->path, config_, grid_config_, matcher_config_);
  graph->reduction.keepWhile([&scans](graph::Key node) { return reductionOf(scans).holds(node); });
  graph->reduction.announceTo([&delayed, &scans](graph::Key node) {
    delayed.forget(node);
    pathOf(scans).forget(node);
  });
  return graph;
}

void GraphSlam::reset() {
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  if (graph_ && graph_->scans) revision_ = gridRevision();
  graph_ = emptyGraph({Pose2(), sigma.cwiseAbs2().asDiagonal()});
  sightings_ = association::Sightings();
  associator_.restart({});
  fixed_map_.clear();
  statistics_ = {};
  events_.clear();
  is_corrected_ = false;
  counters_.clear();
  waiting_.clear();
  refused_.clear();
  resumed_.reset();
  last_motion_.reset();
  has_moved_ = true;
  map_.reset();
  initial_pose_.reset();
  motion_.reset();
  J_wheels_.setZero();
  observations_.reset();
  scan_.reset();
}

LandmarkMap GraphSlam::landmarks() const {
  auto map = config_.mapIsFixed() ? fixed_map_ : graph_->landmarks.map();
  associator_.descriptors().describe(map);
  return map;
}

std::optional<OccupancyGrid> GraphSlam::grid() const {
  return graph_->scans ? graph_->scans->grid() : std::nullopt;
}

std::uint64_t GraphSlam::gridRevision() const {
  return revision_ + (graph_->scans ? graph_->scans->gridRevision() : 0);
}

/// By a scan; the graph's covariance has the errors of the map.
std::optional<Stamp> GraphSlam::correctedBy() const {
  return is_corrected_ ? std::optional(Stamp()) : std::nullopt;
}

std::optional<Stamp> GraphSlam::lostSince() const {
  return graph_->scans ? graph_->scans->doubt().lostSince() : std::nullopt;
}

GraphView GraphSlam::graph() const {
  return viewOf(graph_->path.graph(), graph_->scans ? &*graph_->scans : nullptr);
}

MapState GraphSlam::state() const {
  const auto size = graph_->landmarks.ids().inMap();
  if (config_.mapIsFixed() || uses_grid_ || size > static_cast<std::size_t>(config_.joint_limit))
    return {pose(), landmarks(), {}, grid()};
  auto state = graph_->landmarks.state();
  associator_.descriptors().describe(state.landmarks);
  return state;
}

Status GraphSlam::execute() {
  statistics_ = {};
  events_.clear();
  is_corrected_ = false;
  statistics_.gate_probability = config_.gate_probability;
  resume();
  const auto replaced = replaceMap();
  relocate();
  predict();
  statistics_.landmarks = static_cast<int>(graph_->landmarks.ids().inMap());
  const auto seen = takeObservations();
  const auto scanned = takeScan();
  return moreUrgent(moreUrgent(replaced, mergeWaiting()), moreUrgent(scanned, seen));
}

Status GraphSlam::takeObservations() {
  if (!observations_) return Status::ok();
  const auto z = corrected(*std::exchange(observations_, std::nullopt));
  auto& [path, landmarks, delayed, scans, record, reduction] = *graph_;
  auto association = associator_.associate(z, landmarks, statistics_, counters_);
  if (association.is_solved) landmarks.observe(association.matches, z.sensor_pose);
  if (associator_.goesByPlace()) {
    delayed.keep(z, association, landmarks);
    statistics_.revised_associations =
        delayed.revise(associator_.descriptors(), landmarks, counters_);
  }
  const auto reconsidered = reconsider(association, z.sensor_pose);
  const auto augmented = augment(association, z.sensor_pose);
  path.optimize(config_.iterations);
  removeGhosts(association, z.sensor_pose);
  record.add(z.stamp, path);
  reduction.reduce();
  statistics_.associations = std::move(association.taken);
  statistics_.landmarks = static_cast<int>(landmarks.ids().inMap());
  return summary(association, {augmented, reconsidered});
}

Status GraphSlam::takeScan() {
  if (!scan_) return graph_->scans ? graph_->scans->status() : Status::ok();
  const auto scan = *std::exchange(scan_, std::nullopt);
  const auto taken = graph_->scans->take(scan, counters_);
  is_corrected_ = hasCorrected(graph_->scans->doubt());
  graph_->record.add(scan.stamp, graph_->path);
  events_ = eventsOf(*graph_->scans);
  graph_->reduction.reduce();
  for (const auto node : reductionOf(*graph_->scans).takeReleased())
    graph_->reduction.release(node);
  return moreUrgent(taken, graph_->scans->status());
}

Status GraphSlam::summary(const Association& association,
                          const std::vector<Status>& of_steps) const {
  const bool needs_map = config_.mapIsFixed() && !graph_->scans;
  const auto of_graph = statusOf(association, graph_->path, graph_->landmarks, needs_map);
  if (!of_graph.isOk()) return of_graph;
  const auto fault = std::find_if(of_steps.begin(), of_steps.end(),
                                  [](const Status& status) { return !status.isOk(); });
  return fault == of_steps.end() ? Status::ok() : *fault;
}

Status GraphSlam::replaceMap() {
  if (!map_) return Status::ok();
  const auto map = *std::exchange(map_, std::nullopt);
  if (uses_grid_ && !map.grid)
    return Status::error(
        "the map holds no occupancy grid, without which this back-end cannot take it");
  auto graph = emptyGraph(map.robot, calibration());
  graph->landmarks.load(map, config_.load_inflation);
  Status status;
  if (graph->scans) {
    status = graph->scans->load(*map.grid);
    if (status.level == Status::Level::kError) return status;  // all stays as it is
    graph->scans->restart(map.robot);
    revision_ = gridRevision();
  }
  graph_ = std::move(graph);
  sightings_ = association::Sightings(map.landmarks);
  associator_.restart(map.landmarks);
  if (config_.mapIsFixed()) fixed_map_ = map.landmarks;
  statistics_.prediction.F.setZero();
  return status;
}

void GraphSlam::relocate() {
  if (!initial_pose_) return;
  const auto robot = bounded(*std::exchange(initial_pose_, std::nullopt), largestSigmas());
  graph_->path.relocate(robot);
  if (graph_->scans) graph_->scans->restart(robot);
  statistics_.prediction.F.setZero();
}

void GraphSlam::predict() {
  if (!motion_) return;
  const auto motion = *std::exchange(motion_, std::nullopt);
  associator_.move(motion);
  const auto [F, Q] = graph_->path.predict(motion, J_wheels_);
  if (graph_->scans) graph_->scans->predict(motion);
  statistics_.prediction = {F * statistics_.prediction.F, Q};
  if (!observations_ && !scan_) graph_->record.add(motion.end, graph_->path);
}

Status GraphSlam::reconsider(const Association& association, const Pose2& sensor) {
  auto told = Status::ok();
  for (const auto& verdict : judged(sightings_, association))
    told = moreUrgent(reinitialize(verdict, sensor), told);
  return told;
}

Status GraphSlam::reinitialize(const association::Sightings::Verdict& verdict,
                               const Pose2& sensor) {
  if (config_.mapIsFixed()) return association::Sightings::warningOf(verdict, false);
  const auto& z = verdict.z;
  auto& landmarks = graph_->landmarks;
  sightings_.restart(z.id);
  if (associator_.distrusts(verdict)) {
    idsOf(landmarks).retire(z.id);
    counters_.add("distrusted");
    return association::DistrustedIds::warningOf(z.id);
  }
  landmarks.reinitialize(*landmarks.ids().find(z.id), placeOf(z, pose().pose, sensor), z, sensor);
  counters_.add("begun_anew");
  return association::Sightings::warningOf(verdict, true);
}

void GraphSlam::removeGhosts(const Association& association, const Pose2& sensor) {
  for (const auto id : associator_.ghosts(association, graph_->landmarks, sensor)) {
    idsOf(graph_->landmarks).retire(id);
    counters_.add("ghost");
  }
}

Status GraphSlam::remove(LandmarkId id) {
  auto& ids = idsOf(graph_->landmarks);
  const auto removal = removalOf(id, ids.find(id).has_value(), config_.mapIsFixed());
  if (!removal.isOk()) return removal;
  ids.retire(id);
  sightings_.restart(id);
  associator_.forget(id);
  counters_.add("removed");
  return removal;
}

Status GraphSlam::augment(Association& association, const Pose2& sensor) {
  auto status = Status::ok();
  association::NewLandmarks begun(association.taken);
  for (const auto& z : association.unseen) {
    begun.next();
    const auto place = placeOf(z, pose().pose, sensor);
    if (!place.allFinite()) {
      counters_.add("not_finite");
      status = Status::error("landmark " + std::to_string(z.id) +
                             " would lie at a place that is not finite; it is left out");
      continue;
    }
    graph_->landmarks.append(z.id, place, z, sensor);
    const auto id = graph_->landmarks.ids()[graph_->landmarks.ids().size() - 1];
    begun.setId(id);
    associator_.begin(id, z);
    ++statistics_.added;
  }
  return status;
}

void GraphSlam::saveState(ArchiveWriter& archive) const { archive(*this); }

void GraphSlam::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::graph_slam
