// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::scan_matching {

/// Counts how scans fit the map, and notices when they show nothing for a while.
///
/// Counted: "unmatched" scans, which fit nothing; "searched" scans, which fit only after a search;
/// "jumped" scans, which a wide search found.
class ScanWatch {
 public:
  void restart() { blind_ = unmatched_ = 0; }
  /// @param match of this scan; an empty map cannot match
  /// @param has_motion whether something else has reported the motion
  void note(const ScanLevels& scan, bool map_is_empty, const Match& match, bool has_motion,
            Counters& counters);
  /// A warning if the last scans hold nothing to match, or fit nothing.
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
