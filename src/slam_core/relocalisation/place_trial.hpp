// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <set>

#include "slam_core/relocalisation/area_evidence.hpp"
#include "slam_core/relocalisation/local_scans.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::relocalisation {

/// Tests whether a robot is at a place that a search has found in a grid, or in one that only looks
/// alike, by the scans after that search (sequential test, Wald 1945). The search has chosen the
/// place because its own scans fit there. So they are no evidence for it any more, but the part of
/// them that contradicts the map is evidence against it (evidenceAgainst()). Later scans show
/// surfaces that the scans of the search did not show. Whether the map has these surfaces too
/// distinguishes the two cases. Surfaces that the search has seen already count little.
class PlaceTrial {
 public:
  PlaceTrial() = default;  ///< to be read from an archive
  /// @param map_local T_map_local that the search has found @param seen the scans that it has used
  /// @param prior log-likelihood ratio of the place by what else is known
  PlaceTrial(const Pose2& map_local, const std::deque<LocalScan>& seen, double prior = 0.0);

  /// A prior: the evidence against a place by the scans that a search has used. @param agreement of
  /// all of them with the map there @return 0 if no more of them contradicts the map than is usual
  static double evidenceAgainst(const scan_matching::Agreement& agreement);

  /// To be called for each scan that is kept after the search, with the same map.
  /// @param most the evidence is limited to this
  void see(const LocalScan& scan, const scan_matching::MapView& map,
           const scan_matching::ScanToMapMatcher& matcher, double most);
  /// Log-likelihood ratio of the scans: at this place, over a place that looks alike.
  double evidence() const { return evidence_; }
  /// Moves the place, if something else knows better where the robot is. @param map_local
  /// T_map_local
  void moveTo(const Pose2& map_local) { map_local_ = map_local; }
  /// T_map_base, where this is T_local_base.
  Pose2 placeOf(const Pose2& local) const { return map_local_ * local; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(map_local_, last_, seen_, areas_, evidence_);
  }

 private:
  using Patch = AreaEvidence::Patch;

  double ofNewSurfaces(const grid_map::ScanPoints& scan, const scan_matching::MapView& map,
                       const Pose2& place);
  /// The weight of the last scan, in independent scans.
  double weightOf(const Pose2& local) const;

  Pose2 map_local_;       ///< T_map_local
  Pose2 last_;            ///< T_local_base at the last scan
  std::set<Patch> seen_;  ///< by the search, or counted since
  AreaEvidence areas_;    ///< what new surfaces have shown so far
  double evidence_ = 0.0;
};

}  // namespace slam::relocalisation
