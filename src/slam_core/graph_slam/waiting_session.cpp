// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/waiting_session.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "slam_core/graph/factors.hpp"

namespace slam::graph_slam {
namespace {

std::size_t inMap(const Session& session) {
  std::size_t landmarks = 0;
  for (const auto& landmark : session.landmarks) landmarks += landmark.is_retired ? 0 : 1;
  return landmarks;
}

}  // namespace

WaitingSession::WaitingSession(Session session, const ScanSettings& settings,
                               std::vector<SharedScan> before)
    : session_(std::move(session)), before_(std::move(before)) {
  for (const auto& landmark : session_.landmarks)
    if (!landmark.is_retired) ids_.insert(landmark.id);
  if (!session_.scans.empty()) meeting_.emplace(session_, settings);
}

void WaitingSession::see(const SharedScan& scan) {
  constexpr std::size_t kEvery = 5;
  if (scans_++ % kEvery == 0) look(scan);
}

bool WaitingSession::catchUp() {
  if (before_.empty()) return false;
  look(before_.back());
  before_.pop_back();
  return true;
}

void WaitingSession::look(const SharedScan& scan) {
  if (meeting_ && meeting_->look(seen_.size(), *scan)) seen_.push_back(scan);
}

std::size_t WaitingSession::sharedWith(const LandmarkIds& running) const {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < running.size(); ++i)
    if (!running.isRetired(i)) shared += ids_.count(running[i]);
  return shared;
}

bool WaitingSession::isDue(const LandmarkIds& running) const {
  constexpr std::size_t kEnough = 3;
  const bool has_scans = seen_.size() >= kEnough && seen_.size() > tried_scans_;
  if (has_scans) return true;
  if (session_.kind.has_own_ids) return hasGrown(running.inMap());
  const auto shared = sharedWith(running);
  return shared >= kEnough && shared > tried_landmarks_;
}

/// A constellation is looked for each time that the running map has grown by a fifth.
bool WaitingSession::hasGrown(std::size_t landmarks) const {
  constexpr std::size_t kLeast = 5;
  return landmarks >= tried_landmarks_ + std::max(kLeast, tried_landmarks_ / 5);
}

/// @return what the recognised scans of the running drive say of the waiting map
std::optional<CommonScans> WaitingSession::commonScans(const Session& running) const {
  if (!meeting_) return std::nullopt;
  std::unordered_map<const LaserScan*, Session::Index> nodes;  // looked up only, never iterated
  for (const auto& scan : running.scans) nodes[scan.scan.get()] = scan.node;
  std::vector<std::optional<Pose2>> poses;
  for (const auto& scan : seen_) {
    const auto node = nodes.find(scan.get());
    poses.emplace_back();
    if (node != nodes.end()) poses.back() = running.nodes[node->second];
  }
  const auto agreed = meeting_->agreed(poses);
  if (!agreed) return std::nullopt;
  CommonScans common{agreed->known_drive.inverse(), {}};
  for (const auto& scan : agreed->scans)
    common.places.push_back({joinedNode(running, scan.known), nodes.at(seen_[scan.seen].get()),
                             scan.known_seen, graph::weightOfCovariance(scan.covariance)});
  return common;
}

std::optional<MergedSession> WaitingSession::merged(const Session& running) {
  const auto scans = commonScans(running);
  const auto shared = sharedLandmarks(running, session_, scans);
  tried_landmarks_ = session_.kind.has_own_ids ? inMap(running) : shared.size();
  tried_scans_ = seen_.size();
  const auto links = linksOf(shared, scans);
  if (!links) return std::nullopt;
  return mergedBy(*links, running, session_, GoesOn::kFirst);
}

}  // namespace slam::graph_slam
