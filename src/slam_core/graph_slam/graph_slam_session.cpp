// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/graph_slam/landmark_meeting.hpp"
#include "slam_core/graph_slam/session_file.hpp"
#include "slam_core/graph_slam/session_parts.hpp"
#include "slam_core/models/motion_gap.hpp"

// This file holds how the back-end saves a session, goes on from one and merges one.

namespace slam::graph_slam {
namespace {

/// A robot that goes on within this time is where its odometry says since; later, where the session
/// ended.
constexpr Duration kPause = std::chrono::seconds(10);

/// The motion with what is missing before it, where the odometry has run on since the last one.
Motion withPause(const Motion& last, const Motion& motion) {
  const bool was_restarted = isOrigin(motion.odometry_start) && !isOrigin(last.odometry_end);
  if (was_restarted || motion.start > last.end + kPause) return motion;
  MotionGap gap;
  Motion before = last, after = motion;
  gap.bridge(before);
  return gap.bridge(after) == MotionGap::Bridge::kByPoses ? after : motion;
}

/// Ids of a session's own making are none that an observation may bring.
void requireUsableIds(const Session::Kind& kind, bool goes_by_place) {
  if (kind.has_own_ids && !goes_by_place)
    throw std::runtime_error(
        "its landmarks have ids of its own making and this product goes by the ids of "
        "observations: "
        "run a product with association: nearest, jcbb or descriptor");
}

void requireSameKind(const Session::Kind& kind, bool has_grid, double resolution) {
  if (kind.has_grid && !has_grid)
    throw std::runtime_error(
        "it has a grid and this product makes none: run a product with map: grid");
  if (!kind.has_grid && has_grid)
    throw std::runtime_error(
        "it has no grid and this product makes one: run a product with map: landmarks");
  if (has_grid && kind.resolution != resolution)
    throw std::runtime_error(
        fmt::format("its grid has cells of {:g} m and grid_map.resolution is {:g} m: set it to "
                    "that of the session",
                    kind.resolution, resolution));
}

}  // namespace

void GraphSlam::set(const Motion& motion) {
  const auto whole = has_moved_ || !last_motion_ ? motion : withPause(*last_motion_, motion);
  has_moved_ = true;
  last_motion_ = motion;
  add(whole);
}

SavedSession GraphSlam::session() const {
  if (config_.mapIsFixed())
    throw std::runtime_error(
        "with graph.mode: localization nothing is added to a session: the one that was loaded is "
        "still in its file");
  return {bytesOf(snapshot())};
}

Session GraphSlam::snapshot() const {
  const auto& [path, landmarks, delayed, scans, record, reduction] = *graph_;
  const auto loops = scans ? scans->loops().states() : std::vector<graph::RobustLoops::State>();
  const auto numbers = SessionParts::numbersOf(path, landmarks, loops);
  Session session;
  session.kind = {uses_grid_, uses_grid_ ? grid_config_.resolution : 0.0,
                  associator_.goesByPlace()};
  SessionParts::write(path, numbers, session);
  SessionParts::write(landmarks, numbers, session);
  if (scans) SessionParts::write(*scans, numbers, session);
  SessionParts::write(record, numbers, session);
  if (!session.path.empty()) session.stamp = session.path.back().stamp;
  for (auto& landmark : session.landmarks) {
    const auto seen = sightings_.record(landmark.id);
    landmark.fits = seen.fits;
    landmark.misses = seen.misses;
    if (!landmark.is_retired) landmark.descriptor = associator_.descriptors().of(landmark.id);
  }
  session.last_motion = last_motion_;
  return session;
}

GraphSlam::Resumed GraphSlam::resumed(const Session& session) const {
  Resumed resumed{emptyGraph(session.robot.start), association::Sightings(), LandmarkMap(),
                  session.last_motion};
  auto& [path, landmarks, delayed, scans, record, reduction] = *resumed.graph;
  SessionParts::read(session, path);
  SessionParts::read(session, landmarks);
  if (scans)
    if (const auto status = SessionParts::read(session, *scans);
        status.level == Status::Level::kError)
      throw std::runtime_error(status.message);
  SessionParts::read(session, record);
  reduction.keepAll();
  for (const auto& landmark : session.landmarks) {
    if (landmark.is_retired) continue;
    resumed.sightings.set(landmark.id, {landmark.fits, landmark.misses});
    resumed.known.push_back({landmark.id, landmark.position, Eigen::Matrix2d::Zero(),
                             LandmarkKind::kPoint, 0.0, LineExtent(), landmark.descriptor});
  }
  try {
    const auto& last = path.tail().node;
    if (config_.calibration.isOn())
      calibrate(path, config_.calibration.prior());
    else
      eliminate(path.graph(), last ? std::vector{*last} : std::vector<graph::Key>());
  } catch (const std::domain_error&) {
    throw std::runtime_error("its values are too large to compute with: save the session again");
  }
  return resumed;
}

void GraphSlam::set(const SavedSession& saved) {
  const auto session = sessionOf(saved.bytes);
  requireSameKind(session.kind, uses_grid_, grid_config_.resolution);
  requireUsableIds(session.kind, associator_.goesByPlace());
  auto taken = resumed(session);
  if (!config_.mapIsFixed()) {
    resumed_ = std::move(taken);
    return;
  }
  const auto& [path, landmarks, delayed, scans, record, reduction] = *taken.graph;
  const bool has_joint =
      !scans && landmarks.ids().size() <= static_cast<std::size_t>(config_.joint_limit);
  map_ = has_joint ? landmarks.state() : MapState{path.robot(), landmarks.map(), {}};
  association::DescriptorMap(taken.known).describe(map_->landmarks);
  if (scans) map_->grid = scans->grid();
}

void GraphSlam::merge(const SavedSession& saved) {
  constexpr std::size_t kMostWaiting = 5;
  auto session = sessionOf(saved.bytes);
  requireMergeable(session);
  if (waiting_.size() >= kMostWaiting)
    throw std::runtime_error("five sessions wait to be merged already: drive where they were made");
  waiting_.push_back(std::make_unique<WaitingSession>(
      std::move(session), ScanSettings{config_, grid_config_, matcher_config_}, scansToLookFor()));
}

void GraphSlam::requireMergeable(const Session& session) const {
  if (config_.mapIsFixed())
    throw std::runtime_error(
        "with graph.mode: localization nothing is added to the map: merge while mapping");
  if (config_.calibration.isOn())
    throw std::runtime_error(
        "while parameters are calibrated no session is merged: put what was calibrated into the "
        "robot file, and leave calibration.estimate empty");
  requireSameKind(session.kind, uses_grid_, grid_config_.resolution);
  requireUsableIds(session.kind, associator_.goesByPlace());
  if (!session.kind.has_own_ids && associator_.goesByPlace())
    throw std::runtime_error(
        "its landmarks have the ids that were observed and this product gives them ids of its own: "
        "merge it in a product with association: known_ids");
  if (hasLoadedMap(session))
    throw std::runtime_error(
        "it began with a map that was loaded: load it and merge the other one");
}

/// @return the last scans, and some of all earlier ones, in their order
std::vector<SharedScan> GraphSlam::scansToLookFor() const {
  constexpr std::size_t kLast = 20, kSome = 20;
  if (!graph_->scans) return {};
  const auto all = snapshot().scans;
  const std::size_t earlier = all.size() - std::min(kLast, all.size());
  std::vector<SharedScan> scans;
  for (const auto i : evenlyChosen(kSome, earlier)) scans.push_back(all[i].scan);
  for (std::size_t i = earlier; i < all.size(); ++i) scans.push_back(all[i].scan);
  return scans;
}

std::vector<SavedSession> GraphSlam::waitingSessions() const {
  std::vector<SavedSession> sessions;
  for (const auto& waiting : waiting_) sessions.push_back({bytesOf(waiting->session())});
  return sessions;
}

std::vector<SavedSession> GraphSlam::unmerged() const {
  auto sessions = waitingSessions();
  sessions.insert(sessions.end(), refused_.begin(), refused_.end());
  return sessions;
}

void GraphSlam::waitFor(const std::vector<SavedSession>& sessions) {
  waiting_.clear();
  for (const auto& session : sessions)
    waiting_.push_back(std::make_unique<WaitingSession>(
        sessionOf(session.bytes), ScanSettings{config_, grid_config_, matcher_config_},
        std::vector<SharedScan>()));
}

std::unique_ptr<Backend> GraphSlam::makeAlike() const {
  if (config_.mapIsFixed() || config_.calibration.isOn()) return nullptr;
  auto other = std::make_unique<GraphSlam>();
  other->uses_grid_ = uses_grid_;
  other->association_ = association_;
  other->configure(config_, grid_config_, matcher_config_);
  return other;
}

/// Searches for at most one scan from before. A robot that is lost by its scans is not to be moved,
/// since the merged graph would take it for found.
Status GraphSlam::mergeWaiting() {
  Status status;
  if (lostSince()) return status;
  bool has_searched = false;
  for (auto& waiting : waiting_) {
    const auto& scans = graph_->scans;
    if (scans && insertedBy(*scans)) waiting->see(insertedBy(*scans));
    if (!has_searched) has_searched = waiting->catchUp();
    if (waiting->isDue(graph_->landmarks.ids())) status = moreUrgent(status, mergeBy(waiting));
  }
  waiting_.erase(std::remove(waiting_.begin(), waiting_.end(), nullptr), waiting_.end());
  return status;
}

/// The robot stays where it is: the other map comes to it. A session that has been merged, or
/// cannot be, waits no longer.
Status GraphSlam::mergeBy(std::unique_ptr<WaitingSession>& waiting) {
  try {
    const Pose2 before = pose().pose;
    const auto merged = waiting->merged(snapshot());
    if (!merged) return Status::ok();
    if (graph_->scans) revision_ = gridRevision();
    auto both = resumed(merged->session);
    graph_ = std::move(both.graph);
    sightings_ = std::move(both.sightings);
    associator_.describeBy(both.known);
    const Pose2 moved = before.between(pose().pose);
    counters_.add("merged_sessions");
    events_.push_back({Event::Kind::kMerged,
                       moved.position().norm(),
                       std::abs(moved.theta()),
                       fmt::format("{} landmarks and {} scans of the session that waited",
                                   merged->landmarks, merged->scans),
                       {}});
    waiting.reset();
    return Status::ok();
  } catch (const std::exception& error) {
    constexpr std::size_t kMostKept = 5;
    if (refused_.size() >= kMostKept) refused_.erase(refused_.begin());
    refused_.push_back({bytesOf(waiting->session())});
    waiting.reset();
    return Status::warning(std::string("the session that waited is not merged: ") + error.what());
  }
}

void GraphSlam::resume() {
  if (!resumed_) return;
  if (graph_->scans) revision_ = gridRevision();
  graph_ = std::move(resumed_->graph);
  sightings_ = std::move(resumed_->sightings);
  associator_.restart(resumed_->known);
  last_motion_ = resumed_->last_motion;
  has_moved_ = false;
  motion_.reset();
  statistics_.prediction.F.setZero();
  resumed_.reset();
}

}  // namespace slam::graph_slam
