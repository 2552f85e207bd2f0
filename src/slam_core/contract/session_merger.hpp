// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/session_keeper.hpp"

namespace slam {

/// The capability of a back-end that merges the map of another session into its own during a drive.
/// It keeps sessions as well (SessionKeeper).
class SessionMerger {
 public:
  virtual ~SessionMerger() = default;
  /// The session waits until enough of it is recognised; then its map becomes part of this one,
  /// whose frame and pose stay. Several may wait.
  /// @throw std::runtime_error with what is wrong with the session, as a clause to follow its name,
  /// or that too many wait already; then nothing changes
  virtual void merge(const SavedSession& session) = 0;
  /// @return the sessions that wait, and the last ones that could not be merged
  virtual std::vector<SavedSession> unmerged() const = 0;
  /// Makes an empty back-end that is configured as this one, whose session this one can merge.
  /// @return null where this one merges none
  virtual std::unique_ptr<Backend> makeAlike() const = 0;
};

}  // namespace slam
