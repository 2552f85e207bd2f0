// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "slam_core/relocalisation/local_scans.hpp"
#include "slam_core/relocalisation/place_trials.hpp"
#include "slam_core/relocalisation/recognition.hpp"
#include "slam_core/relocalisation/relocalisation_config.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::relocalisation {

/// Recognises the place of a robot in a grid by what its laser has seen on the last metres. Parts
/// of a building look alike, and another building has parts that look like some of this one. So a
/// place is confirmed only if all that the robot has seen since a search first found it is evidence
/// for this place and for no other one (PlaceTrials), and if the last search finds it as well, and
/// no other place. Even then it is tested further.
class GridRecogniser {
 public:
  GridRecogniser(const RelocalisationConfig& config, const grid_map::GridMapConfig& grid,
                 const scan_matching::MatcherConfig& matcher);

  void move(const Motion& motion) { local_.move(motion); }
  void see(const LaserScan& scan);
  void forget();

  /// Whether the grid has cells, and is small enough to be searched as a whole.
  static bool canSearch(const OccupancyGrid& grid);
  /// Starts to look for the robot in this grid, for which canSearch() holds. To be called after
  /// forget(). @param saved where the robot is unless it was carried (T_map_base): if a search
  /// leads there, the place needs no further confirmation
  void begin(const OccupancyGrid& grid, const std::optional<Pose2>& saved = std::nullopt);
  void end();
  /// Makes the next find() search even if the robot has not moved.
  void searchAnyway() { is_due_ = true; }
  /// To be called between begin() and end(). A search takes some hundredths of a second.
  /// @return nothing if the robot has not moved far enough since the last search
  std::optional<Recognition> find();

  /// The robot is at or near this place (T_map_base), unless it was carried unnoticed, which is far
  /// less common than a map that errs. So other places need more evidence. To be called after
  /// begin().
  friend void expect(GridRecogniser& recogniser, const Pose2& place);

  enum class Test { kGoesOn, kPassed, kRefuted };
  /// Starts to test the place that find() has just confirmed by the scans of the next metres,
  /// instead of searching for other places.
  void beginTest() { confirmed_at_ = local_.way(); }
  friend bool isTesting(const GridRecogniser& recogniser) {
    return recogniser.confirmed_at_.has_value();
  }
  /// To be called after each scan while isTesting(). @param believed the tested place, at the last
  /// scan (T_map_base)
  Test test(const Pose2& believed);
  /// Radius of a circle that holds the grid [m]; 0 if there is none to search.
  friend double radiusOf(const GridRecogniser& recogniser) {
    return recogniser.map_ ? 0.5 * recogniser.box_.diagonal().norm() : 0.0;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(local_, box_.min(), box_.max(), expected_, is_carried_rarely_, confirmed_at_, searched_,
            is_due_, has_news_, trials_);
    archive.made(map_, [this] { return std::make_unique<scan_matching::ScanMap>(grid_config_); });
  }

 private:
  bool isDue() const;
  void leadExpected();
  PlaceTrials::Prior priorOf(const Pose2& place) const;
  bool isExpected(const Pose2& place) const;
  /// Puts the places that a search has found on trial. @return the verdict of the search
  Recognition::Verdict weigh(const scan_matching::Match& best,
                             const scan_matching::ScanLevels& scans);

  RelocalisationConfig config_;
  grid_map::GridMapConfig grid_config_;
  scan_matching::ScanToMapMatcher matcher_;
  LocalScans local_;
  std::unique_ptr<scan_matching::ScanMap> map_;  ///< the grid, while it is searched
  Eigen::AlignedBox2d box_;                      ///< of the map [m]
  std::optional<Pose2> expected_;                ///< T_map_local, if the robot was not carried
  bool is_carried_rarely_ = false;               ///< see expect()
  PlaceTrials trials_;                           ///< of the places that searches have found
  std::optional<double> confirmed_at_;           ///< distance driven when a test began [m]
  double searched_ = 0.0;                        ///< distance driven at the last search [m]
  bool is_due_ = false, has_news_ = false;
};

void expect(GridRecogniser& recogniser, const Pose2& place);

}  // namespace slam::relocalisation
