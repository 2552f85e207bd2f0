// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_watch.hpp"

#include <fmt/format.h>

namespace slam::scan_matching {
namespace {

constexpr int kMany = 10;  // scans in a row

}  // namespace

void ScanWatch::note(const ScanLevels& scan, bool map_is_empty, const Match& match, bool has_motion,
                     Counters& counters) {
  const bool is_blind = scan[0].ends.empty();
  const bool is_unmatched = !map_is_empty && !match.is_determined;
  blind_ = is_blind ? blind_ + 1 : 0;
  unmatched_ = is_unmatched ? unmatched_ + 1 : 0;
  has_motion_ = has_motion;
  if (is_unmatched) counters.add("unmatched");
  if (match.was_searched) counters.add("searched");
  if (match.jumped) counters.add("jumped");
}

Status ScanWatch::status() const {
  const auto* const instead = has_motion_ ? "motion" : "the last velocity";
  if (blind_ >= kMany)
    return Status::warning(
        fmt::format("the last scans hold no range to use, so that {} alone tells the pose: check "
                    "whether the laser is covered, and grid_map.usable_range",
                    instead));
  if (unmatched_ >= kMany)
    return Status::warning(
        fmt::format("the last scans fit nothing in the map, so that {} alone tells the pose: set "
                    "an initial pose if it is wrong, and check the laser and grid_map.usable_range",
                    instead));
  return Status::ok();
}

}  // namespace slam::scan_matching
