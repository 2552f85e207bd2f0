// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "slam_core/scan_matching/match.hpp"
#include "slam_core/scan_matching/matcher_config.hpp"
#include "slam_core/scan_matching/place_search.hpp"
#include "slam_core/scan_matching/registration.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::scan_matching {

/// Finds where a scan fits a map. It starts at the prior in the fine resolution (registerScan()).
/// If that does not explain most of the scan, it starts from the result in the coarse resolution.
/// If too much of the scan still contradicts the map, it searches a window around the prior for a
/// better place (Olson 2009); without odometry this window grows until it covers the sigma of the
/// guess. If necessary it searches a wide window, so that the robot is found again after its wheels
/// slipped or stood still.
///
/// If the prior says how far the map has drifted (PosePrior::information_among_older), a place in
/// the first window counts if it explains half of the ends that contradicted, and where there is
/// none a window follows that is as large as the drift, up to 2 m. The wide window then leads only
/// to where motion and drift may have led the robot, unless most of the scan contradicts the map.
class ScanToMapMatcher {
 public:
  explicit ScanToMapMatcher(const MatcherConfig& config = {}) : config_(config) {}

  /// @param map not empty
  /// @param may_use_wide_window whether the wide window may be searched, which takes about ten
  /// milliseconds
  Match match(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
              bool may_use_wide_window = true) const;

  /// Finds whether and where the scan was taken in the map: the only place in a window around the
  /// prior that explains most of the scan. A window no larger than a local one is not searched.
  /// @return nothing if it fits nowhere, or if it fits another place as well
  std::optional<Match> recognise(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                                 const SearchWindow& window) const;

  /// The same if it is only known that the robot is in this box [m] or not far from it. Things that
  /// have moved since the map was drawn contradict it at the right place, too. So a place that
  /// contradicts more than usual is accepted if all others are far worse.
  std::optional<Match> recogniseAnywhere(const MapView& map, const ScanLevels& scan,
                                         const Eigen::AlignedBox2d& places) const;

  // The steps of recogniseAnywhere(), for callers that also use other evidence.
  /// The place where the largest part of the scan fits the map, whether or not that is enough.
  /// @return nothing if the map or the box is empty or too large to be searched
  std::optional<Match> bestAnywhere(const MapView& map, const ScanLevels& scan,
                                    const Eigen::AlignedBox2d& places) const;
  /// The best place apart from a given one. @return nothing if there is none
  std::optional<Match> rivalAnywhere(const Match& found, const MapView& map, const ScanLevels& scan,
                                     const Eigen::AlignedBox2d& places) const;

  /// @return the surfaces that the ends of a scan fit, if it was matched at this pose
  std::vector<FittedEnd> fittedEnds(const MapView& map, const ScanLevels& scan,
                                    const Pose2& pose) const {
    return scan_matching::fittedEnds(map.finest().map, scan[0], pose, config_.sigma);
  }

  // The steps of match(), for callers that search once for many maps.
  /// The match; or, if most of the scan contradicts the map at the matched pose, the prior's pose
  /// without any information.
  Match believed(Match match, const PosePrior& prior) const;
  /// Without any search.
  Match matchNearby(const MapView& map, const ScanLevels& scan, const PosePrior& prior) const;
  /// Whether so much of the scan contradicts the map that a search for a better place is
  /// worthwhile.
  bool isDoubtful(const Match& match) const;
  /// The better one of two matches: `nearby`, and the match around a place that a search in another
  /// map has found.
  Match orAround(const Pose2& place, const MapView& map, const ScanLevels& scan,
                 const Match& nearby) const;

 private:
  /// @return the windows to search, one after the other, until a place fits: the local one and, if
  /// the prior is a guess, larger ones. Both edges are doubled until the window covers the prior's
  /// sigmas, or 2 m and 1.6 rad if these are smaller; the last window may be larger than that.
  std::vector<SearchWindow> windowsAround(const PosePrior& prior) const;
  /// Whether the scan fits about as well elsewhere within 10 m, or within the window that was
  /// searched where that is wider. @param margin by which the surplus is greater, of all ends
  bool hasRival(const Match& found, const MapView& map, const ScanLevels& scan, const Pose2& middle,
                const SearchWindow& window, double margin) const;
  /// Searches the wide window. @return a place there that justifies a jump, otherwise `nearby`
  Match foundFarAway(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                     const Match& nearby) const;
  /// The better one of two matches: `best`, and one in the windows around the prior.
  Match orInWindows(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                    Match best) const;
  /// The better one of two matches: `nearby`, and one among the older surfaces of the map.
  Match orAmongOlder(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                     const Match& nearby) const;
  /// The match around a place that was found among the older surfaces. @return nothing if it does
  /// not explain most of what contradicts the map nearby
  std::optional<Match> amongOlder(const Pose2& place, const MapView& map, const ScanLevels& scan,
                                  const PosePrior& prior, const Match& nearby) const;
  Match refined(const MapView& map, const ScanLevels& scan, const Pose2& start,
                const PosePrior& prior) const;
  Match searched(const MapView& map, const ScanLevels& scan, const Pose2& middle, double position,
                 double heading) const;
  Match refinedWithin(const MapView& map, const ScanLevels& scan, const Pose2& middle,
                      const SearchWindow& window) const;

  MatcherConfig config_;
};

}  // namespace slam::scan_matching
