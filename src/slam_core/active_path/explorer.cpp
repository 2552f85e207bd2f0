// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/principal_axes.hpp"

namespace slam::active_path {
namespace {

/// The standard deviation of the position in its most uncertain direction [m].
double sigmaOf(const PoseEstimate& pose) {
  return std::sqrt(std::max(largestVariance(pose.covariance.topLeftCorner<2, 2>()), 0.0));
}

std::string faultOf(const PoseEstimate& pose) {
  if (!pose.pose.isFinite()) return "it is not a number";
  if (!pose.covariance.allFinite()) return "its covariance is not a number";
  return "";
}

ViewGain::Sensor sensorOf(const ActivePathConfig& config) {
  return {config.sensor_range, config.field_of_view, config.rays, config.unknown_way};
}

}  // namespace

struct Explorer::Scene {
  Scene(Stamp stamp, const FreeSpace& free_space, Cell start, const PoseEstimate& estimate,
        const ActivePathConfig& config)
      : now(stamp),
        space(free_space),
        position(estimate.pose.position()),
        sigma(sigmaOf(estimate)),
        ways(space, start, config.robot_radius),
        gain(space, sensorOf(config)) {}

  bool reaches(const Eigen::Vector2d& place) const {
    return space.contains(place) && ways.reaches(space.cellAt(place));
  }

  Stamp now;
  const FreeSpace& space;
  Eigen::Vector2d position;  ///< of the robot [m]
  double sigma;              ///< of it [m]
  Ways ways;
  ViewGain gain;
  Decision decision;
};

Explorer::Explorer(const ActivePathConfig& config)
    : config_(config),
      left_out_(config.left_out_radius, durationFromSeconds(config.left_out_time)),
      max_sigma_(config.max_sigma) {
  validate(config);
}

Decision Explorer::decide(Stamp now, const OccupancyGrid& map, const PoseEstimate& pose) {
  if (last_ && now < *last_) reset();
  last_ = now;
  if (is_explored_) return Decision{Decision::State::kExplored, {}, {}, false, {}, {}, {}};
  const auto waiting = [](const std::string& sentence) {
    return Decision{Decision::State::kWaiting, Status::warning(sentence), {}, false, {}, {}, {}};
  };
  if (const auto fault = active_path::faultOf(map); !fault.empty())
    return waiting("the map cannot be explored: " + fault + "; waiting for another one");
  if (const auto fault = faultOf(pose); !fault.empty())
    return waiting("the pose cannot be used: " + fault + "; waiting for another one");
  const FreeSpace space(map, config_.robot_radius);
  const auto start = startOf(space, pose.pose.position(), config_.robot_radius);
  if (!start)
    return waiting(
        fmt::format("the robot at ({:.2f}, {:.2f}) m is outside of the map's known free "
                    "space, or within {} m of an obstacle: drive it where there is room",
                    pose.pose.x(), pose.pose.y(), config_.robot_radius));
  Scene scene(now, space, *start, pose, config_);
  visited_.note(scene.position, scene.sigma);
  watchPosition(scene.sigma);
  judgeKept(scene);
  if (is_closing_) close(scene);
  if (!is_closing_ || !kept_) explore(scene);
  finish(scene);
  return std::move(scene.decision);
}

/// Begins to close a loop above the bound and stops below half of it, so that the robot does not
/// turn round between the two. Each way back raises the bound: where it has not made the places
/// beyond more certain, the robot would go to and fro for ever.
void Explorer::watchPosition(double sigma) {
  constexpr double kRise = 1.5;
  const bool was_closing = is_closing_;
  is_closing_ = sigma > max_sigma_ || (is_closing_ && sigma >= 0.5 * max_sigma_);
  if (was_closing != is_closing_) kept_.reset();
  if (was_closing && !is_closing_) max_sigma_ *= kRise;
}

/// Gives the last goal up where there is a reason to.
void Explorer::judgeKept(Scene& scene) {
  if (!kept_) return;
  auto& goal = kept_->goal;
  const Eigen::Vector2d place = goal.pose.position();
  if ((place - scene.position).norm() <= config_.goal_tolerance) {
    counters_.add("goal_reached");
    if (!goal.closes_loop) left_out_.leaveForGood(place);
    kept_.reset();
  } else if (!scene.reaches(place)) {
    counters_.add("goal_unreachable");
    kept_.reset();
  } else {
    goal.cost = scene.ways.cost(scene.space.cellAt(place));
    if (!goal.closes_loop) goal.gain = scene.gain.at(scene.space.cellAt(place)).gain;
    const bool is_seen = !goal.closes_loop && goal.gain < config_.min_gain;
    if (is_seen) counters_.add("goal_seen");
    if (is_seen)
      kept_.reset();
    else
      keepTime(scene);
  }
}

void Explorer::keepTime(Scene& scene) {
  auto& kept = *kept_;
  if (kept.goal.cost < kept.least_cost - config_.goal_tolerance) {
    kept.least_cost = kept.goal.cost;
    kept.since = scene.now;
  }
  if (scene.now - kept.since <= durationFromSeconds(config_.goal_timeout)) return;
  scene.decision.status = Status::warning(fmt::format(
      "the robot has come no nearer to the goal ({:.2f}, {:.2f}) m for {} s: it is left out; does "
      "anything drive the robot there?",
      kept.goal.pose.x(), kept.goal.pose.y(), config_.goal_timeout));
  counters_.add("goal_not_reached");
  left_out_.leaveForAWhile(kept.goal.pose.position(), scene.now);
  kept_.reset();
}

void Explorer::close(Scene& scene) {
  scene.decision.state = Decision::State::kClosingLoop;
  if (kept_ && kept_->goal.closes_loop) return;
  kept_.reset();
  if (const auto place = bestPlace(scene))
    take(scene, *place);
  else
    scene.decision.status = moreUrgent(
        Status::warning(fmt::format(
            "the position is uncertain (sigma {:.2f} m) and no place that was certain can be "
            "reached: exploring on",
            scene.sigma)),
        scene.decision.status);
}

/// The nearest place at which the position was known well, and which was left long enough ago that
/// seeing it again corrects the pose.
std::optional<Goal> Explorer::bestPlace(const Scene& scene) const {
  std::optional<Goal> best;
  for (const auto& place : visited_.all()) {
    const bool is_certain = place.sigma <= 0.5 * max_sigma_;
    const bool is_left = visited_.wayDriven() - place.way >= config_.loop_distance;
    if (!is_certain || !is_left || !scene.reaches(place.position) ||
        left_out_.contains(place.position, scene.now))
      continue;
    const double cost = scene.ways.cost(scene.space.cellAt(place.position));
    if (best && best->cost <= cost) continue;
    const Eigen::Vector2d ahead = place.position - scene.position;
    best = Goal{{place.position.x(), place.position.y(), std::atan2(ahead.y(), ahead.x())},
                0.0,
                cost,
                true};
  }
  return best;
}

void Explorer::explore(Scene& scene) {
  addCandidates(scene);
  const auto& candidates = scene.decision.candidates;
  const auto best =
      std::max_element(candidates.begin(), candidates.end(),
                       [&](const auto& a, const auto& b) { return rate(a) < rate(b); });
  scene.decision.state = Decision::State::kExploring;
  if (best != candidates.end()) {
    if (!kept_ || rate(*best) > config_.better_factor * rate(kept_->goal)) take(scene, *best);
  } else if (!kept_ && left_out_.isAnyWaiting(scene.now)) {
    scene.decision.state = Decision::State::kWaiting;
  } else if (!kept_) {
    scene.decision.state = Decision::State::kExplored;
    is_explored_ = true;
  }
}

void Explorer::addCandidates(Scene& scene) const {
  auto& decision = scene.decision;
  for (const auto& frontier :
       frontiersOf(scene.space, scene.ways, config_.robot_radius, config_.min_frontier)) {
    for (const Cell cell : frontier.cells) decision.frontiers.push_back(scene.space.centre(cell));
    const Eigen::Vector2d place = scene.space.centre(frontier.viewpoint);
    if (left_out_.contains(place, scene.now)) continue;
    const auto view = scene.gain.at(frontier.viewpoint);
    if (view.gain < config_.min_gain) continue;
    decision.candidates.push_back({{place.x(), place.y(), view.heading},
                                   view.gain,
                                   scene.ways.cost(frontier.viewpoint),
                                   false});
  }
}

/// Gain per metre of way [bit m^2/m]; ways within the tolerance of a goal are equally short.
double Explorer::rate(const Goal& goal) const {
  return goal.gain / std::max(goal.cost, config_.goal_tolerance);
}

void Explorer::take(Scene& scene, const Goal& goal) {
  kept_ = Kept{goal, goal.cost, scene.now};
  scene.decision.is_new = true;
}

void Explorer::finish(Scene& scene) {
  if (!kept_) return;
  scene.decision.goal = kept_->goal;
  scene.decision.way = scene.ways.to(scene.space.cellAt(kept_->goal.pose.position()));
}

void Explorer::resume() {
  left_out_.clear();
  kept_.reset();
  is_explored_ = false;
}

void Explorer::reset() {
  resume();
  visited_ = {};
  max_sigma_ = config_.max_sigma;
  is_closing_ = false;
  last_.reset();
}

}  // namespace slam::active_path
