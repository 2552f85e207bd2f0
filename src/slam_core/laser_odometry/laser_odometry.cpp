// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/laser_odometry.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::laser_odometry {
namespace {

using scan_matching::Match;
using scan_matching::MatcherConfig;
using scan_matching::ScanLevels;

const Registrar<OdometrySource, LaserOdometry> kRegistrar("laser");
const SectionRegistrar<LaserOdometryConfig> kSectionRegistrar;

constexpr Duration kLongestGap = std::chrono::seconds(10);
constexpr double kSlipLeaves = 0.25;  // of the prior's weight
/// Of a motion, so that it is never certain [m^2, rad^2].
constexpr double kLeastVariance = 1e-8;

}  // namespace

void LaserOdometry::configure(const LaserOdometryConfig& config, const MatcherConfig& matcher) {
  FaultCollector faults;
  faults.attempt([&] { validate(config); });
  faults.attempt([&] { validate(matcher); });
  faults.raise();
  config_ = config;
  spacing_ = matcher.spacing;
  grid_map::GridMapConfig map;
  map.resolution = config.resolution;
  map_.emplace(map, config.map_way);
  models_ = scan_matching::levelModels(map);
  constexpr bool kMayJump = false;
  tracker_ =
      scan_matching::ScanTracker(matcher, {config.max_speed, config.max_turn_rate, kMayJump});
  trigger_ = {config.insert_distance, config.insert_angle};
  reset();
}

void LaserOdometry::configure(Settings& settings) {
  LaserOdometryConfig config;
  MatcherConfig matcher;
  FaultCollector faults;
  faults.attempt([&] { settings.read(config); });
  faults.attempt([&] { settings.read(matcher); });
  faults.raise();
  configure(config, matcher);
}

void LaserOdometry::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", this);
  ports.makes<Motion>("motion", motion_);
}

void LaserOdometry::reset() {
  map_->reset();
  tracker_.restart({});
  trigger_.restart();
  input_.reset();
  last_.reset();
  last_sure_.reset();
  ahead_.reset();
  agreement_ = {};
  is_sure_ = is_measured_ = has_turn_ = has_slipped_ = false;
  motion_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status LaserOdometry::execute() {
  motion_.reset();
  const auto scan = std::exchange(input_, std::nullopt);
  if (!scan || isLate(scan->stamp)) return Status::ok();
  const auto stamp = scan->stamp;
  const auto points = scan_matching::pointsOf(*scan, models_, spacing_);
  const auto known = knownOf(stamp);
  const Pose2 before = tracker_.robot().pose;
  const auto& map = map_->view();
  const auto found = known.turn && !known.motion ? tracker_.track(map, points, stamp, *known.turn)
                                                 : tracker_.track(map, points, stamp, known.motion);
  const bool was_sure = is_sure_;
  is_sure_ = !map.isEmpty() && judge(found, known.motion.has_value());
  is_measured_ = was_sure && is_sure_;
  has_turn_ = known.turn.has_value();
  if (last_) motion_ = motionTo(stamp, before, known);
  learn(points, stamp);
  last_ = stamp;
  return explain();
}

LaserOdometry::Known LaserOdometry::knownOf(Stamp stamp) const {
  if (!last_) return {};
  return {source_ ? source_(*last_, stamp) : std::nullopt,
          turn_source_ ? turn_source_(*last_, stamp) : std::nullopt};
}

/// A scan that is stamped wrongly, far ahead, must not make the rest late: it waits for another one
/// that says the same.
bool LaserOdometry::isLate(Stamp stamp) {
  if (!last_) return false;
  if (stamp <= *last_) {
    counters_.add("late");
    return true;
  }
  const bool is_jump = stamp - *last_ > kLongestGap;
  const bool is_confirmed = ahead_ && stamp >= *ahead_ && stamp - *ahead_ < kLongestGap;
  if (is_jump && !is_confirmed) {
    ahead_ = stamp;
    counters_.add("stamp_jump");
    return true;
  }
  ahead_.reset();
  return false;
}

bool LaserOdometry::judge(const Match& found, bool is_told) {
  agreement_ = found.agreement;
  has_slipped_ = is_told && found.is_determined && found.prior_weight < kSlipLeaves;
  if (!found.is_determined) counters_.add("unmatched");
  if (found.was_searched) counters_.add("searched");
  if (found.agreement.mostlyContradicts()) counters_.add("contradicting");
  if (has_slipped_) counters_.add("slips");
  return found.is_determined;
}

Motion LaserOdometry::motionTo(Stamp stamp, const Pose2& before, const Known& known) {
  const auto& step = tracker_.step();
  Motion motion;
  motion.sequence = next_sequence_++;
  motion.start = *last_;
  motion.end = stamp;
  motion.increment = step.increment;
  motion.covariance = step.covariance + kLeastVariance * Eigen::Matrix3d::Identity();
  motion.odometry_start = before;
  motion.odometry_end = tracker_.robot().pose;
  if (is_sure_ || known.motion) return motion;
  const double dt = seconds(stamp - *last_), way = config_.max_speed * dt;
  const double turn = known.turn ? 0.0 : std::min(config_.max_turn_rate * dt, M_PI);
  motion.covariance.diagonal() += Eigen::Vector3d(way * way, way * way, turn * turn);
  return motion;
}

void LaserOdometry::learn(const ScanLevels& scan, Stamp stamp) {
  if (scan[0].beams.empty()) return;
  const auto& pose = tracker_.robot().pose;
  if (is_sure_) last_sure_ = stamp;
  const bool is_elsewhere =
      !is_sure_ && seconds(stamp - last_sure_.value_or(stamp)) > config_.patience;
  if (is_elsewhere) {
    map_->reset();
    last_sure_ = stamp;
    counters_.add("maps");
  }
  const bool is_first = map_->view().isEmpty();
  if (is_first) last_sure_ = stamp;
  if (!is_elsewhere && !is_first && !(is_sure_ && trigger_.isDue(pose))) return;
  map_->insert(scan, pose);
  tracker_.anchor();
  trigger_.note(pose);
}

Status LaserOdometry::explain() const {
  const std::string instead = source_     ? "; the wheels' motion is used meanwhile"
                              : has_turn_ ? "; the last velocity and the gyro are used meanwhile"
                                          : "; the last velocity is used meanwhile";
  if (!is_sure_ && motion_)
    return Status::warning(
        "the laser's scans do not tell the robot's motion: they fit nothing of "
        "what was seen before" +
        instead);
  if (has_slipped_)
    return Status::warning(
        "the wheels tell another motion than the laser, as where they slip or where odometry "
        "stands still; the laser's is used");
  return Status::ok();
}

Component::Figures LaserOdometry::figures() const {
  constexpr double kMegabyte = 1e6;
  const double variance = tracker_.step().covariance.topLeftCorner<2, 2>().diagonal().maxCoeff();
  return {{"known_ends", static_cast<double>(agreement_.known())},
          {"contradicting_ends", agreement_.contradictingShare()},
          {"sigma_position", std::sqrt(variance)},
          {"map_megabytes", static_cast<double>(map_->bytes()) / kMegabyte}};
}

void LaserOdometry::saveState(ArchiveWriter& archive) const { archive(*this); }

void LaserOdometry::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::laser_odometry
