// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/session_keeper.hpp"

namespace slam {

/// The capability of a back-end that merges the map of another session into its own during a drive.
class SessionMerger {
 public:
  virtual ~SessionMerger() = default;
  /// The session waits until enough of it is recognised; then its map becomes part of this one,
  /// whose frame and pose stay. It replaces a session that is waiting already.
  /// @throw std::runtime_error with what is wrong with the session, as a clause to follow its name;
  /// then nothing changes
  virtual void merge(const SavedSession& session) = 0;
};

}  // namespace slam
