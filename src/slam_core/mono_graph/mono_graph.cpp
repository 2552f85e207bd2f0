// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/mono_graph.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/covariance.hpp"
#include "slam_core/mono_graph/pose_chain.hpp"

namespace slam::mono_graph {
namespace {

const Registrar<Backend, MonoGraph> kRegistrar("mono_graph");
const SectionRegistrar<MonoGraphConfig> kSectionRegistrar;

constexpr double kInitialVariance = 1e-6;  // [m^2, rad^2]
constexpr std::size_t kLeastFeatures = 30;
constexpr double kFewShared = 0.5;     // of the points of the reference
constexpr double kNearKeyframe = 0.4;  // of the usual distance

int countOfPoints(const Keyframe& keyframe) {
  return static_cast<int>(keyframe.points.size()) -
         static_cast<int>(std::count(keyframe.points.begin(), keyframe.points.end(), kNoPoint));
}

}  // namespace

void MonoGraph::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", &inputs_).carrier();
  ports.takes<CameraView>("camera", "what the camera sees", &inputs_);
}

void MonoGraph::describe(Capabilities& capabilities) {
  capabilities.offer<EventReporter>(*this);
  capabilities.offer<GraphReporter>(*this);
  capabilities.offer<PathReviser>(*this);
}

void MonoGraph::configure(const MonoGraphConfig& config) {
  requireUsable(config);
  config_ = config;
  orb_ = OrbExtractor(config.features, config.sigma);
  reset();
}

void MonoGraph::configure(Settings& settings) { configure(settings.read<MonoGraphConfig>()); }

void MonoGraph::reset() {
  map_ = {};
  mapper_ = LocalMapper(config_.window);
  anchor_ = way_ = {};
  anchor_.place({}, kInitialVariance * Eigen::Matrix3d::Identity());
  way_.place({}, Eigen::Matrix3d::Zero());
  reference_.reset();
  predict();
  path_.clear();
  events_.clear();
  inputs_ = {};
  counters_.clear();
}

Status MonoGraph::execute() {
  events_.clear();
  relocate();
  for (const auto& motion : std::exchange(inputs_.motions, {})) move(motion);
  predict();
  const auto view = std::exchange(inputs_.view, std::nullopt);
  if (!view) return Status::ok();
  const auto status = see(*view);
  noteStep(view->stamp);
  return status;
}

/// A map that is kept has nothing to do with the new pose.
void MonoGraph::relocate() {
  if (!inputs_.initial_pose) return;
  const auto initial = *std::exchange(inputs_.initial_pose, std::nullopt);
  anchor_.place(initial.pose, initial.covariance);
  reference_.reset();
}

void MonoGraph::move(const Motion& motion) {
  anchor_.move(motion);
  way_.move(motion);
}

void MonoGraph::predict() {
  const auto prior = anchor_.predicted();
  pose_ = prior.pose;
  covariance_ = prior.covariance;
}

Status MonoGraph::see(const CameraView& view) {
  if (!view.isUsable() || view.image.gray.empty()) {
    counters_.add("unusable");
    return Status::ok();  // the camera's gate has said why
  }
  const auto features = orb_.extract(view);
  if (features.size() >= kLeastFeatures) return follow(view, features);
  counters_.add("blank");
  return Status::warning(
      "the camera sees next to nothing, as in a dark room or before a blank wall: the pose follows "
      "odometry alone meanwhile");
}

Status MonoGraph::follow(const CameraView& view, const Features& features) {
  TrackedView tracked;
  tracked.pose = pose_;
  if (reference_)
    tracked = track(map_, features, anchor_.predicted(), keyframesAround(map_, *reference_));
  const bool is_tracked = tracked.matches.size() >= static_cast<std::size_t>(config_.least_points);
  if (getenv("DBG"))
    fprintf(stderr, "DBG %.2f f %zu exp %zu m %zu rej %zu kf %zu pts %zu\n",
            double(nanoseconds(view.stamp) % 1000000000000) * 1e-9, features.size(),
            tracked.expected.size(), tracked.matches.size(), tracked.rejected.size(),
            map_.keyframes().size(), map_.countOfPoints());
  if (is_tracked)
    believe(tracked);
  else if (reference_)
    counters_.add("untracked");
  if (!wantsKeyframe(tracked)) return Status::ok();
  return addKeyframe(view, features, tracked);
}

void MonoGraph::believe(const TrackedView& tracked) {
  for (const int point : tracked.expected) ++map_.point(point).expected;
  for (const auto& match : tracked.matches) ++map_.point(match.point).found;
  reference_ = referenceOf(map_, tracked.matches);
  pose_ = tracked.pose;
  covariance_ = tracked.covariance;
  anchor_.place(pose_, symmetric(tracked.information.inverse()));
}

/// @param share of the distance and the turn that make a keyframe
bool MonoGraph::isFarFromKeyframes(double share) const {
  auto nearby = reference_ ? keyframesAround(map_, *reference_) : std::vector<int>();
  if (!map_.keyframes().empty()) nearby.push_back(static_cast<int>(map_.keyframes().size()) - 1);
  return std::all_of(nearby.begin(), nearby.end(), [&](int number) {
    const Pose2 apart = map_.keyframe(number).pose.between(pose_);
    return apart.position().norm() >= share * config_.keyframe_distance ||
           std::abs(apart.theta()) >= share * config_.keyframe_turn;
  });
}

/// Where an image shows few of the points that its reference does, new ones are needed.
bool MonoGraph::wantsKeyframe(const TrackedView& tracked) const {
  const auto shown = reference_ ? countOfPoints(map_.keyframe(*reference_)) : 0;
  const bool are_few = static_cast<double>(tracked.matches.size()) < kFewShared * shown;
  return isFarFromKeyframes(are_few ? kNearKeyframe : 1.0);
}

Status MonoGraph::addKeyframe(const CameraView& view, const Features& features,
                              const TrackedView& tracked) {
  if (map_.keyframes().size() >= static_cast<std::size_t>(config_.most_keyframes)) {
    counters_.add("keyframes_full");
    return Status::warning(
        "mono_graph.most_keyframes keyframes are remembered and no more: raise it to go on "
        "mapping");
  }
  Keyframe keyframe;
  keyframe.stamp = view.stamp;
  keyframe.pose = pose_;
  keyframe.features = features;
  if (!map_.keyframes().empty()) keyframe.way = way_.since();
  keyframe.way_covariance = way_.covarianceSince();
  const int number = map_.add(std::move(keyframe));
  for (const auto& match : tracked.matches)
    map_.addSighting(match.point, {number, static_cast<int>(match.feature)});
  mapper_.map(map_);
  auto& added = map_.keyframe(number);
  added.covariance = chainedCovariance(map_, number).value_or(covariance_);
  const Eigen::Matrix3d of_pose = kInitialVariance * Eigen::Matrix3d::Identity();
  reference_ = number;
  pose_ = added.pose;
  covariance_ = of_pose;
  anchor_.place(pose_, of_pose);
  way_.place({}, Eigen::Matrix3d::Zero());
  return Status::ok();
}

void MonoGraph::noteStep(Stamp stamp) {
  path_.push_back(
      {stamp, reference_, reference_ ? map_.keyframe(*reference_).pose.between(pose_) : pose_});
}

PoseEstimate MonoGraph::pose() const {
  if (!reference_) return {pose_, covariance_};
  const auto& origin = map_.keyframe(*reference_);
  return {pose_, chained(origin.pose, origin.covariance, pose_, covariance_)};
}

Component::Figures MonoGraph::figures() const {
  return {{"keyframes", static_cast<double>(map_.keyframes().size())},
          {"points", static_cast<double>(map_.countOfPoints())}};
}

GraphView MonoGraph::graph() const {
  GraphView view;
  const auto& keyframes = map_.keyframes();
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    view.nodes.push_back(keyframes[i].pose);
    if (keyframes[i].way)
      view.edges.push_back({GraphEdge::Kind::kMotion, keyframes[i - 1].pose.position(),
                            keyframes[i].pose.position()});
  }
  return view;
}

std::vector<StampedPose> MonoGraph::path() const {
  std::vector<StampedPose> path;
  for (const auto& point : path_)
    path.push_back({point.stamp, point.keyframe ? map_.keyframe(*point.keyframe).pose * point.pose
                                                : point.pose});
  return path;
}

}  // namespace slam::mono_graph
