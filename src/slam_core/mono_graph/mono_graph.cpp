// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/mono_graph.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/covariance.hpp"
#include "slam_core/mono_graph/pose_chain.hpp"
#include "slam_core/mono_graph/two_views.hpp"

namespace slam::mono_graph {
namespace {

const Registrar<Backend, MonoGraph> kRegistrar("mono_graph");
const SectionRegistrar<MonoGraphConfig> kSectionRegistrar;

constexpr double kInitialVariance = 1e-6;  // [m^2, rad^2]
constexpr std::size_t kLeastFeatures = 30;
constexpr std::size_t kMuch = 100;         // features of an image that shows much
constexpr int kProven = 3;                 // images that have shown a point
constexpr double kFewShared = 0.5;         // of the points of the reference
constexpr double kNearKeyframe = 0.4;      // of the usual distance
constexpr double kWayWithoutPoints = 3.0;  // without points, although images show much [m]

Eigen::Matrix3d initialCovariance() { return kInitialVariance * Eigen::Matrix3d::Identity(); }

double countOfPoints(const Keyframe& keyframe) {
  const auto none = std::count(keyframe.points.begin(), keyframe.points.end(), kNoPoint);
  return static_cast<double>(keyframe.points.size()) - static_cast<double>(none);
}

Vocabulary vocabularyOf(const MonoGraphConfig& config) {
  if (config.vocabulary.empty()) return Vocabulary::builtIn();
  try {
    return Vocabulary::load(config.vocabulary);
  } catch (const std::runtime_error& error) {
    throw ConfigError(std::string("mono_graph.vocabulary: ") + error.what());
  }
}

}  // namespace

void MonoGraph::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", &inputs_).carrier();
  ports.takes<CameraView>(CameraConfig::kSection, "what the camera sees", &inputs_);
}

void MonoGraph::describe(Capabilities& capabilities) {
  capabilities.offer<CorrectionReporter>(*this);
  capabilities.offer<EventReporter>(*this);
  capabilities.offer<FeatureMapper>(*this);
  capabilities.offer<GraphReporter>(*this);
  capabilities.offer<LostReporter>(*this);
  capabilities.offer<PathReviser>(*this);
  capabilities.offer<PlaceReporter>(*this);
  capabilities.offer<ViewDrawer>(*this);
  capabilities.offer<ViewReporter>(*this);
}

void MonoGraph::configure(const MonoGraphConfig& config) {
  requireUsable(config);
  vocabulary_ = vocabularyOf(config);
  config_ = config;
  orb_ = OrbExtractor(config.features, config.sigma);
  reset();
}

void MonoGraph::configure(Settings& settings) { configure(settings.read<MonoGraphConfig>()); }

void MonoGraph::reset() {
  map_ = {};
  mapper_ = {};
  recogniser_ = PlaceRecogniser(config_.least_place_points, seed_);
  closer_ = {};
  doubt_ = TrackingDoubt();
  continuity_.settle();
  standstill_.settle();
  way_ = {};
  reference_.reset();
  unadjusted_.reset();
  unrecognised_.reset();
  putAt({}, initialCovariance());
  is_tracked_ = false;
  has_view_ = false;
  seen_ = {};
  path_.clear();
  events_.clear();
  inputs_ = {};
  counters_.clear();
}

Status MonoGraph::execute() {
  events_.clear();
  is_tracked_ = false;
  has_view_ = false;
  relocate();
  for (const auto& motion : std::exchange(inputs_.motions, {})) move(motion);
  predict();
  const auto view = std::exchange(inputs_.view, std::nullopt);
  if (!view) return Status::ok();
  const auto status = see(*view);
  noteStep(view->stamp);
  return status;
}

/// The map is kept; where the robot now is in it, it is tracked by what is near.
void MonoGraph::relocate() {
  if (!inputs_.initial_pose) return;
  const auto initial = *std::exchange(inputs_.initial_pose, std::nullopt);
  putAt(initial.pose, initial.covariance);
  reference_ = nearestKeyframe();
}

void MonoGraph::putAt(const Pose2& pose, const Eigen::Matrix3d& covariance) {
  anchor_.place(pose, covariance);
  last_ = {};
  is_way_known_ = false;
  way_without_points_ = 0.0;
  doubt_.settle();
  continuity_.settle();
  standstill_.settle();
  agreement_.clear();
  predict();
}

std::optional<int> MonoGraph::nearestKeyframe() const {
  constexpr double kNear = 1.0;  // [m, rad]
  std::optional<int> nearest;
  double least = kNear;
  for (int i = 0; i < static_cast<int>(map_.keyframes().size()); ++i) {
    const Pose2 apart = map_.keyframe(i).pose.between(pose_);
    const double distance = apart.position().norm() + std::abs(apart.theta());
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

void MonoGraph::move(const Motion& motion) {
  anchor_.move(motion);
  way_.move(motion);
  agreement_.move(motion);
  continuity_.move(motion);
  standstill_.move(motion);
}

void MonoGraph::predict() {
  const auto prior = anchor_.predicted();
  pose_ = prior.pose;
  covariance_ = prior.covariance;
}

Status MonoGraph::see(const CameraView& view) {
  seen_ = {};
  finishKeyframe();
  if (!view.isUsable() || view.image.gray.empty()) {
    counters_.add("unusable");
    return Status::ok();  // the camera's gate has said why
  }
  const auto features = orb_.extract(view);
  seen_ = {view.image.gray, features, {}};
  has_view_ = true;
  if (features.size() >= kLeastFeatures) return follow(view, features);
  counters_.add("blank");
  return Status::warning(
      "the camera sees next to nothing, as in a dark room or before a blank wall: the pose follows "
      "odometry alone meanwhile");
}

Status MonoGraph::follow(const CameraView& view, const Features& features) {
  if (isLost()) lookForPlace(features);
  if (isLost()) return Status::ok();
  auto seen = tracked(features);
  if (!showsRobot(seen) && correctStep(features)) seen = tracked(features);
  const auto of_map = viewOfMap(features, seen);
  seen_.tracked = seen;
  const auto statistics = *viewStatistics();
  counters_.add("matched", statistics.matched);
  counters_.add("rejected", statistics.rejected);
  is_tracked_ = showsRobot(seen);
  if (is_tracked_)
    believe(seen);
  else if (reference_)
    counters_.add("untracked");
  doubt_.judge(of_map, pose_, view.stamp);
  continuity_.judge(features, view.stamp);
  if (seen.expected.size() < static_cast<std::size_t>(config_.least_points))
    standstill_.judge(features, view.stamp);
  last_ = features;
  anchor_.beginStep();
  if (doubt_.isLost())
    return Status::alarm(
        "the robot is lost: the camera sees next to nothing of what the map has here; drive on "
        "slowly where the robot has been, or set an initial pose");
  if (continuity_.isLost())
    return Status::alarm(
        "the robot is lost: the camera sees another scene than a moment ago, as if the robot had "
        "been carried; drive on slowly where the robot has been, or set an initial pose");
  if (standstill_.isLost())
    return Status::alarm(
        "the robot is lost: what the camera sees moves, while odometry says that the robot stands; "
        "check the wheels' encoders, and that the wheels are on the ground");
  if (!mayMap() || !wantsKeyframe(seen)) return Status::ok();
  return addKeyframe(view, features, seen);
}

bool MonoGraph::showsRobot(const TrackedView& tracked) const {
  return tracked.matches.size() >= static_cast<std::size_t>(config_.least_points);
}

/// Odometry since the last image has the heading that both images agree on, if they do.
bool MonoGraph::correctStep(const Features& features) {
  const auto step = motionBetween(last_, features, anchor_.step());
  if (!step) return false;
  anchor_.correctStep(*step);
  predict();
  return true;
}

/// Several images in a row have to agree before the robot is put anywhere.
void MonoGraph::lookForPlace(const Features& features) {
  const auto place = recogniser_.find(map_, features, vocabulary_.wordsOf(features.all()), {},
                                      config_.least_similarity);
  if (!place || !agreement_.add(place->pose)) return;
  putAt(place->pose, place->covariance);
  reference_ = place->keyframe;
}

TrackedView MonoGraph::tracked(const Features& features) const {
  if (reference_)
    return track(map_, features, anchor_.predicted(), keyframesAround(map_, *reference_));
  TrackedView nothing;
  nothing.pose = pose_;
  return nothing;
}

void MonoGraph::believe(const TrackedView& tracked) {
  for (const int point : tracked.expected) ++map_.point(point).expected;
  for (const auto& match : tracked.matches) ++map_.point(match.point).found;
  reference_ = referenceOf(map_, tracked.matches);
  pose_ = tracked.pose;
  covariance_ = tracked.covariance + scaleCovariance(map_, *reference_, pose_);
  anchor_.place(pose_, symmetric(tracked.information.inverse()));
}

/// Counts points that images show as a rule. Those that were mapped since the doubt began agree
/// with the pose whether it is right or not.
ViewOfMap MonoGraph::viewOfMap(const Features& features, const TrackedView& tracked) const {
  const auto since = doubt_.doubtedSince();
  const auto counts = [&](int number) {
    const auto& point = map_.point(number);
    return point.found >= kProven && 4 * point.found >= 3 * point.expected &&
           (!since || map_.keyframe(point.host()).stamp < *since);
  };
  ViewOfMap view;
  view.in_reach = tracked.in_reach;
  for (const int point : tracked.expected) view.expected += counts(point) ? 1 : 0;
  for (const auto* found : {&tracked.matches, &tracked.unfitted})
    for (const auto& match : *found) view.found += counts(match.point) ? 1 : 0;
  const bool shows_much = features.size() >= std::min(kMuch, 2 * view.expected);
  return shows_much ? view : ViewOfMap();  // else it is dark or blurred
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
  const double shown = reference_ ? countOfPoints(map_.keyframe(*reference_)) : 0.0;
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
  if (!is_tracked_) pose_ = poseByImages(features);
  Keyframe keyframe;
  keyframe.stamp = view.stamp;
  keyframe.pose = pose_;
  keyframe.features = features;
  const auto way = way_.since();
  if (is_way_known_) keyframe.way = way.pose;
  keyframe.way_covariance = way.covariance;
  const Eigen::Matrix3d covariance = pose().covariance;  // where nothing chains it to others
  const int number = map_.add(std::move(keyframe));
  for (const auto& match : tracked.matches)
    map_.addSighting(match.point, {number, static_cast<int>(match.feature)});
  mapper_.map(map_);
  map_.keyframe(number).covariance =
      chainedCovariance(map_, number)
          .value_or(ChainCovariance{covariance, Eigen::Matrix3d::Zero(), 0.0});
  recogniser_.add(vocabulary_.wordsOf(features.all()));
  unadjusted_ = reference_ = number;
  pose_ = map_.keyframe(number).pose;
  covariance_ = initialCovariance();
  anchor_.place(pose_, covariance_);
  way_.place({}, Eigen::Matrix3d::Zero());
  is_way_known_ = true;
  return judgeMapping(number);
}

/// Judges whether the map gets points. Two keyframes that see much share points if odometry reports
/// the way between them as the robot drove it. A way on which nothing was seen does not count.
Status MonoGraph::judgeMapping(int number) {
  const auto& keyframe = map_.keyframe(number);
  const double most = 2.0 * config_.keyframe_distance;
  if (countOfPoints(keyframe) >= config_.least_points)
    way_without_points_ = 0.0;
  else if (keyframe.way && keyframe.features.size() >= kMuch &&
           map_.keyframe(number - 1).features.size() >= kMuch)
    way_without_points_ += std::min(keyframe.way->position().norm(), most);
  if (way_without_points_ < kWayWithoutPoints) return Status::ok();
  counters_.add("without_points");
  return Status::warning(
      "the camera sees much, but no points that fit the motion that odometry reports: the pose is "
      "odometry's; check the direction and scale of odometry, and the camera's mount and "
      "calibration");
}

/// The pose where points do not show the robot: what the last keyframe saw tells the heading.
Pose2 MonoGraph::poseByImages(const Features& features) const {
  if (!is_way_known_) return pose_;
  const auto& before = map_.keyframes().back();
  const auto motion = motionBetween(before.features, features, way_.since());
  return motion ? before.pose * motion->pose : pose_;
}

void MonoGraph::noteStep(Stamp stamp) {
  const Pose2 relative = reference_ ? map_.keyframe(*reference_).pose.between(pose_) : pose_;
  path_.push_back({stamp, reference_, relative, firstVisit()});
}

void MonoGraph::saveState(ArchiveWriter& archive) const { archive(*this); }

void MonoGraph::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::mono_graph
