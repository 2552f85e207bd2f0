// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::scan_matching {

/// Counts what scans fit, and notices where they show nothing for a while.
///
/// Counted: "unmatched" scans, that fit nothing; "searched" ones, that fit only where a search has
/// led; "jumped" ones, found by a wide search.
class ScanWatch {
 public:
  void restart() { blind_ = unmatched_ = 0; }
  /// @param match of this scan; an empty map cannot match
  /// @param has_motion whether something else has reported the motion
  void note(const ScanLevels& scan, bool map_is_empty, const Match& match, bool has_motion,
            Counters& counters);
  /// A warning where the last scans hold nothing to match, or fit nothing.
  Status status() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(blind_, unmatched_, has_motion_);
  }

 private:
  int blind_ = 0, unmatched_ = 0;  ///< scans in a row up to the last one
  bool has_motion_ = false;
};

}  // namespace slam::scan_matching
