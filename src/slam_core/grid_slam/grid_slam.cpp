// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_slam/grid_slam.hpp"

#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/models/moved_pose.hpp"

namespace slam::grid_slam {
namespace {

using scan_matching::MapDrift;
using scan_matching::Match;
using scan_matching::ScanLevels;

const Registrar<Backend, GridSlam> kRegistrar("grid");
const SectionRegistrar<GridSlamConfig> kSectionRegistrar;
const SectionRegistrar<grid_map::GridMapConfig> kGridMapRegistrar;
const SectionRegistrar<scan_matching::MatcherConfig> kMatcherRegistrar;

}  // namespace

void GridSlam::configure(const GridSlamConfig& config, const grid_map::GridMapConfig& grid,
                         const scan_matching::MatcherConfig& matcher) {
  FaultCollector faults;
  faults.attempt([&] { validate(config); });
  faults.attempt([&] { validate(grid); });
  faults.attempt([&] { validate(matcher); });
  faults.raise();
  config_ = config;
  map_config_ = grid;
  models_ = scan_matching::levelModels(grid);
  spacing_ = matcher.spacing;
  tracker_ = scan_matching::ScanTracker(matcher);
  doubt_ = scan_matching::ScanDoubt(config.lost_share, matcher.false_alarm_hours, mapIsFixed());
  trigger_ = {config.insert_distance, config.insert_angle};
  drift_ =
      mapIsFixed() ? MapDrift(0.0, 0.0) : MapDrift(config.drift_position, config.drift_heading);
  reset();
}

void GridSlam::configure(Settings& settings) {
  GridSlamConfig config;
  grid_map::GridMapConfig grid;
  scan_matching::MatcherConfig matcher;
  FaultCollector faults;
  faults.attempt([&] { settings.read(config); });
  faults.attempt([&] { settings.read(grid); });
  faults.attempt([&] { settings.read(matcher); });
  faults.raise();
  configure(config, grid, matcher);
}

void GridSlam::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", &inputs_).carrier().optional();
  ports.takes<LaserScan>("scan", "laser scans", &inputs_);
}

void GridSlam::describe(Capabilities& capabilities) {
  capabilities.offer<CorrectionReporter>(*this);
  capabilities.offer<GridMapper>(*this);
  capabilities.offer<LostReporter>(*this);
  capabilities.offer<MapKeeper>(*this);
}

void GridSlam::reset() {
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  map_ = std::make_unique<scan_matching::ScanMap>(map_config_);
  ++revision_;
  tracker_.restart({});
  trigger_.restart();
  drift_.restart({Pose2(), sigma.cwiseAbs2().asDiagonal()});
  carried_.reset();
  doubt_.forget();
  watch_.restart();
  is_corrected_ = false;
  inputs_ = {};
  counters_.clear();
}

Status GridSlam::execute() {
  const auto replaced = replaceMap();
  relocate();
  move();
  is_corrected_ = false;
  const auto scan = std::exchange(inputs_.scan, std::nullopt);
  if (!scan) return moreUrgent(replaced, onTheWhole());
  const auto levels = scan_matching::pointsOf(*scan, models_, spacing_);
  const auto found = match(levels, scan->stamp);
  const auto learnt = learn(levels, found);
  return moreUrgent(moreUrgent(learnt, replaced), onTheWhole());
}

Status GridSlam::replaceMap() {
  if (!inputs_.map) return Status::ok();
  const auto map = *std::exchange(inputs_.map, std::nullopt);
  if (!map.grid)
    return Status::error(
        "the map holds no occupancy grid, without which this back-end cannot take it");
  auto loaded = std::make_unique<scan_matching::ScanMap>(map_config_);
  Status status;
  for (std::size_t i = 0; i < scan_matching::kLevels; ++i) {
    auto& [model, grid] = loaded->level(i);
    status = moreUrgent(fillFrom(*map.grid, model, grid), status);
  }
  if (status.level == Status::Level::kError) return status;  // all stays as it is
  map_ = std::move(loaded);
  ++revision_;
  drift_.restartInLoadedMap(map.robot.pose);
  if (!inputs_.initial_pose) inputs_.initial_pose = map.robot;
  return status;
}

void GridSlam::relocate() {
  if (!inputs_.initial_pose) return;
  tracker_.restart(*std::exchange(inputs_.initial_pose, std::nullopt));
  drift_.relocate(tracker_.robot().pose);
  trigger_.restart();
  carried_.reset();
  doubt_.forget();
  watch_.restart();
}

void GridSlam::move() {
  const auto motion = std::exchange(inputs_.motion, std::nullopt);
  if (motion) carried_ = carried_ ? joined(*carried_, *motion) : *motion;
}

Match GridSlam::match(const ScanLevels& scan, Stamp stamp) {
  const auto motion = std::exchange(carried_, std::nullopt);
  const auto drift =
      mapIsFixed() ? std::nullopt : std::optional(drift_.covarianceAt(tracker_.robot().pose));
  const auto found = tracker_.track(map_->view(), scan, stamp, motion, drift);
  if (!mapIsFixed())
    drift_.follow(tracker_.robot(), found, tracker_.fittedEnds(map_->view(), scan));
  watch_.note(scan, map_->isEmpty(), found, motion.has_value(), counters_);
  doubt_.judge(found, stamp);
  is_corrected_ = hasCorrected(doubt_);
  return found;
}

Status GridSlam::learn(const ScanLevels& scan, const Match& found) {
  if (!doubt_.admits()) {
    counters_.add("contradicting");
    return Status::ok();
  }
  const bool is_due = map_->isEmpty() || trigger_.isDue(found.pose);
  if (mapIsFixed() || !is_due || scan[0].beams.empty()) return Status::ok();
  return insert(scan, found);
}

/// A scan that fits nothing shows what the map does not have yet: the robot goes on from there,
/// less sure of where that is. So does one that fits in some directions only, as along a corridor:
/// what it shows at the end of the corridor is drawn where the robot guesses to be. The scans after
/// it fit that end well, and would be sure of a place that nobody knows.
Status GridSlam::insert(const ScanLevels& scan, const Match& found) {
  if (!grid_map::isWithinMemory(
          static_cast<double>(map_->bytes()) + scan_matching::mostBytesFor(scan), map_config_)) {
    counters_.add("scans_without_memory");
    return Status::warning(
        "the grid map would need more than grid_map.largest_memory and is kept as it is: raise it "
        "or grid_map.resolution");
  }
  const auto& pose = tracker_.robot().pose;
  const auto beyond = map_->insert(scan, pose);
  trigger_.note(pose);
  if (!found.is_determined || drift_.isSurerThan(tracker_.robot())) {
    drift_.anchor(tracker_.robot().covariance);
    tracker_.anchor();
  }
  drift_.add(scan[0], pose);
  ++revision_;
  if (beyond == 0) return Status::ok();
  counters_.add("beams_beyond_map", beyond);
  return Status::warning(
      "beams end beyond the largest grid map, what lies there is not mapped: "
      "raise grid_map.largest_area");
}

Status GridSlam::onTheWhole() const {
  if (mapIsFixed() && map_->isEmpty())
    return Status::warning("there is no map to localise in; load one");
  if (const auto told = doubt_.status(); !told.isOk()) return told;
  return watch_.status();
}

PoseEstimate GridSlam::pose() const {
  PoseEstimate told = tracker_.robot();
  told.covariance += drift_.covarianceAt(told.pose);
  return carried_ ? moved(told, *carried_) : told;
}

Component::Figures GridSlam::figures() const {
  constexpr double kMegabyte = 1e6;
  return {{"contradicting_ends", doubt_.agreement().contradictingShare()},
          {"known_ends", static_cast<double>(doubt_.agreement().known())},
          {"lost_statistic", doubt_.statistic()},
          {"lost_for_s", seconds(doubt_.lostFor())},
          {"map_megabytes", static_cast<double>(map_->bytes()) / kMegabyte}};
}

/// The map counts as exact here, since MapDrift already adds its errors.
std::optional<Stamp> GridSlam::correctedBy() const {
  return is_corrected_ ? std::optional(Stamp()) : std::nullopt;
}

std::optional<OccupancyGrid> GridSlam::grid() const {
  return occupancyGridOf(map_->finest().map, map_->finest().model.resolution());
}

MapState GridSlam::state() const { return {pose(), {}, {}, grid()}; }

void GridSlam::saveState(ArchiveWriter& archive) const { archive(*this); }

void GridSlam::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::grid_slam
