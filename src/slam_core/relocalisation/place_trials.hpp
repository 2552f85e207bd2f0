// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/relocalisation/place_trial.hpp"

namespace slam::relocalisation {

/// The places that searches have found, each on trial by all later scans (PlaceTrial). A search
/// that finds nothing, or another place, ends no trial: two places that look alike are two
/// hypotheses, until what the robot sees next distinguishes them.
///
/// Among many tried places, one may look like the robot's by chance. So the odds that a place must
/// reach grow with the number of tried places (Bonferroni; Dunn 1961). This keeps the probability
/// that a wrong place is believed below one in `odds`.
class PlaceTrials {
 public:
  /// @param odds that the only place on trial must reach
  explicit PlaceTrials(double odds) : odds_(odds) {}

  void forget();
  /// To be called for each scan that is kept, with the same map. Places that turn out to be the
  /// same are merged.
  void see(const LocalScan& scan, const scan_matching::MapView& map,
           const scan_matching::ScanToMapMatcher& matcher);
  enum class Prior {
    kNone,      ///< the robot may be anywhere
    kExpected,  ///< the robot is there unless it was carried
    kUnlikely   ///< the robot is elsewhere unless it was carried, which nothing shows
  };
  /// To be called when a search has found a place: puts it on trial, unless it is already. @param
  /// found T_map_base at the last scan, and how much of the scans fits there @param local
  /// T_local_base of the last scan
  /// @param seen the scans that the search has used
  void lead(const scan_matching::Match& found, const Pose2& local,
            const std::deque<LocalScan>& seen, Prior prior);
  /// Whether the evidence for this place is enough, and that for all other places on trial is much
  /// smaller.
  /// @param local T_local_base, where the robot would be at `place`
  bool isEnoughFor(const Pose2& place, const Pose2& local) const;
  /// Whether isEnoughFor() holds for one of the places.
  bool hasEnough() const;

  /// Ends the trials of all places but this one, for which isEnoughFor() holds.
  void keepOnly(const Pose2& place, const Pose2& local);
  /// The place that keepOnly() has left.
  PlaceTrial& only() { return trials_.front(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(trials_, tried_);
  }

 private:
  using Trials = std::vector<PlaceTrial>;

  Trials::iterator find(const Pose2& place, const Pose2& local);
  Trials::const_iterator find(const Pose2& place, const Pose2& local) const;
  bool isEnough(const PlaceTrial& trial) const;
  void dropWorst();
  /// Logarithm of the odds that a place must reach.
  double enough() const;
  double evidenceAtFirst(const scan_matching::Match& found, Prior prior) const;
  /// The limit of the evidence, so that a refuted place may still turn out to be right.
  double most() const;

  double odds_;
  Trials trials_;
  double tried_ = 0.0;  ///< places so far
};

}  // namespace slam::relocalisation
