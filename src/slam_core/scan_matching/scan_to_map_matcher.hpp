// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "slam_core/scan_matching/agreement.hpp"
#include "slam_core/scan_matching/matcher_config.hpp"
#include "slam_core/scan_matching/place_search.hpp"
#include "slam_core/scan_matching/registration.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::scan_matching {

/// What matching a scan with a map has found.
struct Match {
  Pose2 pose;                                             ///< T_map_base, with the prior's help
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< that the scan has of it
  Agreement agreement;
  double prior_weight = 1.0;      ///< robust weight of the prior, 0 to 1; 0 where it was searched
  bool is_determined = false;     ///< enough ends fit to say something
  bool was_searched = false;      ///< where the prior led nothing fitted
  bool wide_search_done = false;  ///< it may have found nothing
  /// By a wide search: seen from where the prior led.
  std::optional<Pose2> jumped;
};

/// Finds where a scan fits a map: from the prior on in the fine resolution (registerScan()), and
/// where that does not explain most of the scan, from where the coarse one leads. Where too much of
/// the scan contradicts the map even so, it searches a window around the prior for a better place
/// (Olson 2009), which without odometry grows until it covers the guess's sigma, and a wide one if
/// need be, so that the robot is found again after wheels that slipped or stood still.
class ScanToMapMatcher {
 public:
  explicit ScanToMapMatcher(const MatcherConfig& config = {}) : config_(config) {}

  /// @param map not empty
  /// @param may_use_wide_window whether it may be searched, which takes about ten milliseconds
  Match match(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
              bool may_use_wide_window = true) const;

  /// Whether the scan has been taken within the map, and where: the only place in a window around
  /// the prior that explains most of what the scan sees. In a window that is no larger than a local
  /// one there is no need to search.
  /// @return nothing where it fits nowhere, or as well elsewhere
  std::optional<Match> recognise(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                                 const SearchWindow& window) const;

  /// The same where nothing is known but that the robot is at one of these places [m], or not far
  /// from them. What has moved since the map was drawn contradicts it at the right place too: a
  /// place that more contradicts than is usual counts where all others are far worse.
  std::optional<Match> recogniseAnywhere(const MapView& map, const ScanLevels& scan,
                                         const Eigen::AlignedBox2d& places) const;

  // The steps of recogniseAnywhere(), for who weighs what was found by other evidence as well.
  /// The place where most of the scan fits the map, whether or not that is enough.
  /// @return nothing where the map or the places are none, or too large to be searched
  std::optional<Match> bestAnywhere(const MapView& map, const ScanLevels& scan,
                                    const Eigen::AlignedBox2d& places) const;
  /// The best one that lies apart from a place. @return nothing where there is none
  std::optional<Match> rivalAnywhere(const Match& found, const MapView& map, const ScanLevels& scan,
                                     const Eigen::AlignedBox2d& places) const;

  // The steps of match(), for who searches once for many maps.
  /// The match, or the prior's pose without any information where the scan contradicts most of the
  /// map at the matched pose.
  Match believed(Match match, const PosePrior& prior) const;
  /// Without any search.
  Match matchNearby(const MapView& map, const ScanLevels& scan, const PosePrior& prior) const;
  /// Whether so much contradicts the map that a better place is worth a search.
  bool isDoubtful(const Match& match) const;
  /// The better one of what was found nearby and what is there around a place that a search in
  /// another map has led to.
  Match orAround(const Pose2& place, const MapView& map, const ScanLevels& scan,
                 const Match& nearby) const;

 private:
  /// @return the windows to search, one after the other, until a place fits: the local one and,
  /// where the prior is a guess, larger ones. Both edges are doubled until the window covers the
  /// prior's sigmas, or 2 m and 1.6 rad where these are smaller; the last may be larger than that.
  std::vector<SearchWindow> windowsAround(const PosePrior& prior) const;
  /// Whether the scan fits about as well elsewhere within 10 m, or within the window that was
  /// searched where that is wider. @param margin by which the surplus is greater, of all ends
  bool hasRival(const Match& found, const MapView& map, const ScanLevels& scan, const Pose2& middle,
                const SearchWindow& window, double margin) const;
  /// Searches the wide window. @return a place there that is worth a jump, else `nearby`
  Match foundFarAway(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                     const Match& nearby) const;
  Match refined(const MapView& map, const ScanLevels& scan, const Pose2& start,
                const PosePrior& prior) const;
  Match searched(const MapView& map, const ScanLevels& scan, const Pose2& middle, double position,
                 double heading) const;
  Match refinedWithin(const MapView& map, const ScanLevels& scan, const Pose2& middle,
                      const SearchWindow& window) const;

  MatcherConfig config_;
};

}  // namespace slam::scan_matching
