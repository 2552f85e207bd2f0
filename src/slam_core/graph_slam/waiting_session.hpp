// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <unordered_set>
#include <vector>

#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/scan_meeting.hpp"
#include "slam_core/graph_slam/session_merge.hpp"

namespace slam::graph_slam {

/// A session that waits to be merged with the running one: it watches for what both have seen.
///
/// Call order: see() for each scan that became a node, and catchUp() in each step; then, where
/// isDue(), merged().
class WaitingSession {
 public:
  /// @param before scans of the running drive that were nodes already, to be looked for from the
  /// last to the first
  WaitingSession(Session session, const ScanSettings& settings, std::vector<SharedScan> before);
  WaitingSession(const WaitingSession&) = delete;  // its parts point to one another
  WaitingSession& operator=(const WaitingSession&) = delete;

  /// Looks for every fifth of these scans in the waiting map, which takes some ten milliseconds.
  void see(const SharedScan& scan);
  /// Looks for the next of the scans from before. @return false where none is left
  bool catchUp();
  /// Whether something has been recognised since merged() was called the last time.
  bool isDue(const LandmarkIds& running) const;
  /// Both as one in the frame of the running session, whose robot goes on.
  /// @return nothing where too little is recognised
  /// @throw std::invalid_argument with a sentence where they contradict each other
  std::optional<MergedSession> merged(const Session& running);
  const Session& session() const { return session_; }

  /// The session itself is saved apart.
  template <class Archive>
  void persist(Archive& archive) {
    archive(before_, seen_, scans_, tried_landmarks_, tried_scans_);
    if (meeting_) archive(*meeting_);
  }

 private:
  void look(const SharedScan& scan);
  std::optional<CommonScans> commonScans(const Session& running) const;
  std::size_t sharedWith(const LandmarkIds& running) const;
  bool hasGrown(std::size_t landmarks) const;

  const Session session_;
  std::unordered_set<LandmarkId> ids_;  // looked up only, never iterated
  std::optional<ScanMeeting> meeting_;  ///< where it has scans
  std::vector<SharedScan> before_;      ///< still to be looked for
  std::vector<SharedScan> seen_;        ///< those that were recognised
  std::size_t scans_ = 0;               ///< that became nodes
  /// Recognised when merged() was called; where ids are of its own making, in the running map.
  std::size_t tried_landmarks_ = 0;
  std::size_t tried_scans_ = 0;  ///< recognised when merged() was called
};

}  // namespace slam::graph_slam
