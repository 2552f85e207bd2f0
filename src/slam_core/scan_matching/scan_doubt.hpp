// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include "slam_core/scan_matching/agreement.hpp"

namespace slam::scan_matching {

/// Whether scans still fit the map they are matched with. People and moved chairs make some ends
/// contradict it; where most do, it is the robot that is not where it should be. Doubt lasts for
/// some scans: a robot that draws a map anew where it takes itself to be soon fits it.
class ScanDoubt {
 public:
  /// @param lost_share of the ends in known cells that contradict the map
  explicit ScanDoubt(double lost_share = 0.5) : lost_share_(lost_share) {}

  /// To be called for each scan, before it goes into the map. @return whether this one contradicts
  bool judge(const Agreement& agreement) {
    agreement_ = agreement;
    scans_in_doubt_ = std::max(0, scans_in_doubt_ - 1);
    const bool contradicts = agreement.contradictingShare() > lost_share_;
    if (contradicts) scans_in_doubt_ = kLasting;
    return contradicts;
  }
  /// Whether the last scan, or one of the few before it, contradicted the map.
  bool isLost() const { return scans_in_doubt_ > 0; }
  /// Of the last scan.
  const Agreement& agreement() const { return agreement_; }
  /// A new place or map: what was seen before says nothing of it.
  void forget() {
    agreement_ = {};
    scans_in_doubt_ = 0;
  }

 private:
  static constexpr int kLasting = 5;  // [scans]
  double lost_share_;
  Agreement agreement_;
  int scans_in_doubt_ = 0;  ///< to come
};

}  // namespace slam::scan_matching
