// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_merge.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/session_graph.hpp"

namespace slam::graph_slam {
namespace {

/// Of the second drive, so many scans are looked for.
constexpr std::size_t kScans = 30;

struct Alike {
  std::optional<LandmarkMeeting> landmarks;
  std::optional<ScanMeeting::Agreed> scans;
};

std::optional<ScanMeeting::Agreed> scansInCommon(const Session& first, const Session& second,
                                                 const ScanSettings& settings) {
  if (first.scans.empty() || second.scans.empty()) return std::nullopt;
  ScanMeeting meeting(first, settings);
  for (const auto i : evenlyChosen(kScans, second.scans.size()))
    meeting.look(second.scans[i].node, *second.scans[i].scan);
  std::vector<Pose2> poses;
  for (const auto& scan : meeting.recognised()) poses.push_back(second.nodes[scan.seen]);
  return meeting.agreed(poses);
}

/// Where the two ways to find it say the same.
Pose2 alignmentOf(const Alike& alike) {
  constexpr double kLargestShift = 1.0, kLargestTurn = 0.15;  // [m], [rad]
  if (!alike.landmarks && !alike.scans)
    throw std::invalid_argument(
        "the two sessions have nothing in common: no three landmarks that lie alike, and no scans "
        "of one that are recognised in the map of the other");
  if (!alike.landmarks) return alike.scans->known_drive;
  const Pose2 first_second = alike.landmarks->first_second;
  if (!alike.scans) return first_second;
  const Pose2 error = first_second.between(alike.scans->known_drive);
  if (error.position().norm() > kLargestShift || std::abs(error.theta()) > kLargestTurn)
    throw std::invalid_argument(
        "landmarks and scans contradict each other on how the two sessions lie; were tags moved?");
  return first_second;
}

/// The covariance of each landmark that is asked for.
class Marginals {
 public:
  explicit Marginals(const Session& session) : session_(session), graph_(optimizerOf(session)) {
    graph_.update({});
  }
  Eigen::Matrix2d of(std::size_t landmark) const {
    return graph_.covariance({keyOfLandmark(session_, static_cast<Session::Index>(landmark))});
  }

 private:
  const Session& session_;
  graph::Optimizer graph_;
};

SessionLinks linksOf(const Session& first, const std::vector<SharedLandmark>& shared,
                     const Alike& alike) {
  SessionLinks links{alignmentOf(alike), {}, {}};
  if (alike.landmarks)
    for (const auto i : alike.landmarks->agreeing)
      links.landmarks.emplace_back(shared[i].first, shared[i].second);
  if (alike.scans)
    for (const auto& scan : alike.scans->scans)
      links.places.push_back({scan.known, joinedNode(first, static_cast<Session::Index>(scan.seen)),
                              scan.known_seen, graph::weightOfCovariance(scan.covariance)});
  return links;
}

}  // namespace

std::vector<SharedLandmark> sharedLandmarks(const Session& first, const Session& second) {
  std::unordered_map<LandmarkId, std::size_t> numbers;  // looked up only, never iterated
  for (std::size_t i = 0; i < first.landmarks.size(); ++i) numbers[first.landmarks[i].id] = i;
  std::vector<SharedLandmark> shared;
  for (std::size_t i = 0; i < second.landmarks.size(); ++i) {
    const auto known = numbers.find(second.landmarks[i].id);
    if (known == numbers.end()) continue;
    shared.push_back({known->second,
                      i,
                      first.landmarks[known->second].position,
                      second.landmarks[i].position,
                      {},
                      {}});
  }
  if (shared.empty()) return shared;
  const Marginals in_first(first), in_second(second);
  for (auto& landmark : shared) {
    landmark.first_covariance = in_first.of(landmark.first);
    landmark.second_covariance = in_second.of(landmark.second);
  }
  return shared;
}

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

MergedSession merged(const Session& first, const Session& second, const ScanSettings& settings,
                     GoesOn goes_on) {
  requireJoinable(first, second);
  const auto shared = sharedLandmarks(first, second);
  const Alike alike{meetingOf(shared), scansInCommon(first, second, settings)};
  const auto links = linksOf(first, shared, alike);
  MergedSession result{joined(first, second, links, goes_on), links.first_second,
                       links.landmarks.size(), links.places.size(), shared.size()};
  settle(result.session);
  return result;
}

}  // namespace slam::graph_slam
