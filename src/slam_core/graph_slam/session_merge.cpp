// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_merge.hpp"

#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/session_graph.hpp"

namespace slam::graph_slam {
namespace {

/// At most so many scans of the second drive are looked for.
constexpr std::size_t kScans = 30;

/// Scans of the second session that are recognised in the map of the first.
std::optional<CommonScans> commonScans(const Session& first, const Session& second,
                                       const ScanSettings& settings) {
  if (first.scans.empty() || second.scans.empty()) return std::nullopt;
  ScanMeeting meeting(first, settings);
  for (const auto i : evenlyChosen(kScans, second.scans.size()))
    meeting.look(second.scans[i].node, *second.scans[i].scan);
  std::vector<std::optional<Pose2>> poses;
  for (const auto& scan : meeting.recognised()) poses.emplace_back(second.nodes[scan.seen]);
  const auto agreed = meeting.agreed(poses);
  if (!agreed) return std::nullopt;
  CommonScans common{agreed->known_drive, {}};
  for (const auto& scan : agreed->scans)
    common.places.push_back({scan.known, joinedNode(first, static_cast<Session::Index>(scan.seen)),
                             scan.known_seen, graph::weightOfCovariance(scan.covariance)});
  return common;
}

}  // namespace

void settle(Session& session) {
  constexpr int kMostSteps = 30;
  constexpr double kAtRest = 0.01;  // [m], [rad]
  auto graph = optimizerOf(session);
  const bool is_at_rest = graph.optimize({}, kMostSteps);
  follow(graph, session);
  if (!is_at_rest) {
    const auto before = session.nodes;
    graph.optimize({}, 1);
    follow(graph, session);
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].between(session.nodes[i]).vector().cwiseAbs().maxCoeff() > kAtRest)
        throw std::invalid_argument(
            "the graph of both sessions does not come to rest: what was taken for the same place "
            "is none");
  }
  for (auto& scan : session.scans) scan.drawn = session.nodes[scan.node];
}

std::vector<SharedLandmark> sharedLandmarks(const Session& first, const Session& second,
                                            const std::optional<CommonScans>& scans) {
  if (!first.kind.has_own_ids) return sharedById(first, second);
  const auto first_second =
      scans ? std::optional<Pose2>(scans->first_second) : constellationMeeting(first, second);
  if (!first_second) return {};
  return sharedByPlace(first, second, *first_second);
}

std::optional<SessionLinks> linksOf(const std::vector<SharedLandmark>& shared,
                                    const std::optional<CommonScans>& scans) {
  const auto landmarks = meetingOf(shared);
  if (!landmarks && !scans) return std::nullopt;
  if (landmarks && scans && !areAlike(landmarks->first_second, scans->first_second))
    throw std::invalid_argument(
        "landmarks and scans contradict each other on how the two sessions lie; were tags moved?");
  SessionLinks links;
  links.first_second = landmarks ? landmarks->first_second : scans->first_second;
  if (landmarks)
    for (const auto i : landmarks->agreeing)
      links.landmarks.emplace_back(shared[i].first, shared[i].second);
  if (scans) links.places = scans->places;
  return links;
}

MergedSession mergedBy(const SessionLinks& links, const Session& first, const Session& second,
                       GoesOn goes_on) {
  MergedSession result{joined(first, second, links, goes_on), links.first_second,
                       links.landmarks.size(), links.places.size()};
  settle(result.session);
  return result;
}

MergedSession merged(const Session& first, const Session& second, const ScanSettings& settings,
                     GoesOn goes_on) {
  requireJoinable(first, second);
  const auto scans = commonScans(first, second, settings);
  const auto links = linksOf(sharedLandmarks(first, second, scans), scans);
  if (links) return mergedBy(*links, first, second, goes_on);
  throw std::invalid_argument(
      "the two sessions have nothing in common: no three landmarks that lie alike, and no scans of "
      "one that are recognised in the map of the other");
}

}  // namespace slam::graph_slam
