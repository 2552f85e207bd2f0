// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/session_keeper.hpp"

namespace slam {

/// The capability of a back-end that puts the map of another drive onto its own while it drives.
class SessionMerger {
 public:
  virtual ~SessionMerger() = default;
  /// The session waits until enough of it is recognised; then its map becomes part
  /// of this one, whose frame and pose stay. It takes the place of one that waits already.
  /// @throw std::runtime_error with what is wrong with the session, to stand behind its name; all
  /// stays as it is
  virtual void merge(const SavedSession& session) = 0;
};

}  // namespace slam
