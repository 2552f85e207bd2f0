// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/graph_slam/landmark_meeting.hpp"
#include "slam_core/graph_slam/scan_meeting.hpp"
#include "slam_core/graph_slam/session_join.hpp"
#include "slam_core/graph_slam/shared_landmarks.hpp"

namespace slam::graph_slam {

/// Two sessions as one, and what they were recognised by.
struct MergedSession {
  Session session;
  Pose2 first_second;                    ///< T_first_second, of the map frames, before the merge
  std::size_t landmarks = 0, scans = 0;  ///< that say so
};

/// Puts the map of a second session onto that of a first one, in whose map frame the result is:
/// landmarks of the same id that lie alike, and scans of the second drive that are recognised in
/// the map of the first, become factors of one graph, which is optimised. Of landmarks whose ids
/// are of the sessions' own making, those are the same that lie at one place when a constellation
/// of them or the scans have shown how the maps lie.
/// @throw std::invalid_argument with a sentence where nothing in common is found, where landmarks
/// and scans contradict each other, where the joined graph does not come to rest, or as joined()
MergedSession merged(const Session& first, const Session& second, const ScanSettings& settings,
                     GoesOn goes_on);

// The following does the same in steps, for a robot that recognises scans while it drives.

/// Scans that both sessions have, and what they say.
struct CommonScans {
  Pose2 first_second;                    ///< T_first_second, of the map frames
  std::vector<Session::Between> places;  ///< between nodes of the joined session
};

/// @return nothing where nothing is in common
/// @throw std::invalid_argument where landmarks and scans contradict each other
std::optional<SessionLinks> linksOf(const std::vector<SharedLandmark>& shared,
                                    const std::optional<CommonScans>& scans);
/// @throw std::invalid_argument where the joined graph does not come to rest
MergedSession mergedBy(const SessionLinks& links, const Session& first, const Session& second,
                       GoesOn goes_on);
/// The landmarks that both sessions have, by their ids; where these are of the sessions' own making
/// by how the landmarks lie.
std::vector<SharedLandmark> sharedLandmarks(const Session& first, const Session& second,
                                            const std::optional<CommonScans>& scans);

/// Optimises the graph of a session, and takes over where it has nodes, landmarks and scans.
/// @throw std::invalid_argument where it does not come to rest
void settle(Session& session);

}  // namespace slam::graph_slam
