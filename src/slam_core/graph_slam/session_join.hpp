// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include "slam_core/graph_slam/session.hpp"

namespace slam::graph_slam {

/// The links hold two sessions together.
struct SessionLinks {
  Pose2 first_second;  ///< T_first_second, of the map frames
  /// These landmarks are the same, by their numbers in the first and second session. Other
  /// landmarks of the second one whose id the first one has are left out, but where ids are of the
  /// sessions' own making: then they get others. Retired ones of the second are left out.
  std::vector<std::pair<Session::Index, Session::Index>> landmarks;
  /// Places that were recognised, between nodes of the joined session. The first one is taken for
  /// granted, so that the sessions hang together; the others are loops that can be taken back.
  std::vector<Session::Between> places;
};

/// Whose robot goes on in the joined session.
enum class GoesOn { kFirst, kSecond };

/// The number that a node of the second session gets in the joined one.
inline Session::Index joinedNode(const Session& first, Session::Index of_second) {
  return static_cast<Session::Index>(first.nodes.size()) + of_second;
}

/// Whether it began with a map that was loaded, which says where its own map frame lies.
bool hasLoadedMap(const Session& session);
/// @throw std::invalid_argument with a sentence where the sessions are of different kinds, or the
/// second one began with a map that was loaded
void requireJoinable(const Session& first, const Session& second);

/// One session of two, in the map frame of the first: nodes, landmarks, factors, scans and submaps
/// of both. Its graph is not optimised. What the second session said of where its own map frame
/// lies is dropped; between its nodes it stays.
/// @throw std::invalid_argument as requireJoinable()
Session joined(const Session& first, const Session& second, const SessionLinks& links,
               GoesOn goes_on);

}  // namespace slam::graph_slam
