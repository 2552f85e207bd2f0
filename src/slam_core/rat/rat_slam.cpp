// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/rat_slam.hpp"

#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/moved_pose.hpp"

namespace slam::rat {
namespace {

const Registrar<Backend, RatSlam> kRegistrar("rat");
const SectionRegistrar<ExperienceConfig> kSectionRegistrar;

constexpr double kInitialVariance = 1e-6;  // [m^2, rad^2]

}  // namespace

void RatSlam::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", &inputs_).carrier();
  ports.takes<PoseCellState>("pose_cells", "pose cells", &inputs_);
}

void RatSlam::describe(Capabilities& capabilities) {
  capabilities.offer<EventReporter>(*this);
  capabilities.offer<GraphReporter>(*this);
  capabilities.offer<PathReviser>(*this);
  capabilities.offer<PlaceReporter>(*this);
  capabilities.offer<WithoutCovariance>(*this);
}

void RatSlam::configure(const ExperienceConfig& config) {
  requireUsable(config);
  config_ = config;
  reset();
}

void RatSlam::configure(Settings& settings) { configure(settings.read<ExperienceConfig>()); }

void RatSlam::reset() {
  map_ = ExperienceMap(config_);
  covariance_ = kInitialVariance * Eigen::Matrix3d::Identity();
  way_.clear();
  events_.clear();
  inputs_ = {};
  counters_.clear();
}

Status RatSlam::execute() {
  events_.clear();
  relocate();
  for (const auto& motion : std::exchange(inputs_.motions, {})) move(motion);
  const auto cells = std::exchange(inputs_.cells, std::nullopt);
  if (!cells) return Status::ok();
  const auto arrival = arrive(*cells);
  map_.relax();
  noteStep(cells->stamp, arrival != ExperienceMap::Arrival::kNowhere);
  return moreUrgent(statusOf(*cells, arrival), forgetSteps());
}

void RatSlam::relocate() {
  if (!inputs_.initial_pose) return;
  const auto initial = *std::exchange(inputs_.initial_pose, std::nullopt);
  map_.placeAt(initial.pose);
  covariance_ = initial.covariance;
}

void RatSlam::move(const Motion& motion) {
  covariance_ = moved({map_.pose(), covariance_}, motion).covariance;
  map_.move(motion.increment);
}

ExperienceMap::Arrival RatSlam::arrive(const PoseCellState& state) {
  const Pose2 before = map_.pose();
  const auto arrival = map_.arrive(state);
  if (arrival == ExperienceMap::Arrival::kLoop) noteLoop(before);
  return arrival;
}

Status RatSlam::statusOf(const PoseCellState& state, ExperienceMap::Arrival arrival) {
  if (arrival != ExperienceMap::Arrival::kNowhere || state.view == kNoView) return Status::ok();
  counters_.add("experiences_full");
  return Status::warning(
      "rat.most_experiences places are remembered and no more: raise it to go on mapping");
}

void RatSlam::noteLoop(const Pose2& before) {
  const Pose2 after = map_.pose();
  Event event;
  event.kind = Event::Kind::kLoopClosed;
  event.distance = (after.position() - before.position()).norm();
  event.turn = std::abs(wrapAngle(after.theta() - before.theta()));
  event.reason = "view " + std::to_string(map_.experiences()[*map_.current()].view) +
                 " is recognised where the pose cells expect it";
  events_.push_back(event);
  counters_.add("loops");
}

void RatSlam::noteStep(Stamp stamp, bool is_at_place) {
  const auto here = map_.current();
  WayPoint point{stamp, here, here ? map_.sinceCurrent() : map_.pose(), std::nullopt};
  if (is_at_place) point.first_visit = map_.experiences()[*here].first_visit;
  way_.push_back(point);
}

Status RatSlam::forgetSteps() {
  if (way_.size() <= static_cast<std::size_t>(config_.most_steps)) return Status::ok();
  way_.pop_front();
  counters_.add("steps_forgotten");
  return Status::warning(
      "rat.most_steps steps of the way are remembered and no more: its beginning is not revised "
      "any "
      "more, and places.csv lacks it; raise it to keep the whole way");
}

PoseEstimate RatSlam::pose() const { return {map_.pose(), covariance_}; }

Component::Figures RatSlam::figures() const {
  return {{"experiences", static_cast<double>(map_.experiences().size())},
          {"links", static_cast<double>(map_.links().size())}};
}

GraphView RatSlam::graph() const {
  GraphView view;
  const auto& experiences = map_.experiences();
  for (const auto& experience : experiences) view.nodes.push_back(experience.pose);
  for (const auto& link : map_.links())
    view.edges.push_back({link.is_loop ? GraphEdge::Kind::kLoop : GraphEdge::Kind::kMotion,
                          experiences[link.from].pose.position(),
                          experiences[link.to].pose.position()});
  return view;
}

std::vector<StampedPose> RatSlam::path() const {
  std::vector<StampedPose> path;
  for (const auto& point : way_)
    path.push_back({point.stamp, point.experience
                                     ? map_.experiences()[*point.experience].pose * point.pose
                                     : point.pose});
  return path;
}

std::vector<PlaceVisit> RatSlam::visits() const {
  std::vector<PlaceVisit> visits;
  for (const auto& point : way_) visits.push_back({point.stamp, point.first_visit});
  return visits;
}

void RatSlam::saveState(ArchiveWriter& archive) const { archive(*this); }

void RatSlam::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::rat
