// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/consistency/gating_rate.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/relocalisation/grid_recogniser.hpp"
#include "slam_core/relocalisation/landmark_doubt.hpp"
#include "slam_core/relocalisation/landmark_recogniser.hpp"
#include "slam_core/relocalisation/scan_change.hpp"

namespace slam::relocalisation {

/// How much the pose of a back-end is trusted.
enum class Belief {
  kSure,         ///< there is no evidence against it
  kUnconfirmed,  ///< it came with a loaded map, in which no place has been recognised yet
  kLost,         ///< what is seen contradicts the map around it, or changed at once
  kAnywhere      ///< global localisation was requested: the robot may be anywhere in the map
};

/// Judges whether the robot is at the back-end's pose. If it is not, finds it in the back-end's map
/// by the landmarks around it, or by what its laser has seen on the last metres. It needs only the
/// map and the innovations of a back-end, so that it serves all of them.
///
/// The Estimator calls configure() once; then, for each step, predict() with the motions, see()
/// with what was seen and, after the back-end's own step, judge(). Counted: "withheld"
/// (observations that the back-end did not get), "unlike_last" (scans that are unlike the last one;
/// the back-end does not get them either), "relocalised", "withdrawn" (places that later data have
/// refuted).
class Relocaliser {
 public:
  /// @param capabilities of the back-end, which outlives this object @param ids whether
  /// observations and map share their ids @throw ConfigError
  void configure(Settings& settings, const Capabilities& capabilities, LocalLandmarks::Ids ids);
  void reset();

  /// To be called when the robot was put somewhere, when a map was loaded, or when the pose is in
  /// doubt. If the map cannot be searched, the belief becomes kSure, whatever was asked for. This
  /// is so if it has fewer than two point landmarks, and no grid or one that is too large.
  /// @param loaded the map that the back-end was just given; avoids asking the back-end for a copy
  /// @return a warning if a loaded map cannot be searched, so that its pose is believed as it is
  Status assume(Belief belief, const MapState* loaded = nullptr);
  /// Searches the grid with the next scan, even if the robot stands still.
  void searchAnyway();

  void predict(const Motion& motion);
  /// @return whether the back-end may use it as well; from a wrong pose it would map new landmarks,
  /// or walls, at wrong places
  bool see(const LandmarkObservationArray& array);
  bool see(const LaserScan& scan);

  /// @return the pose of the robot, if it was found at another one than the back-end's
  std::optional<PoseEstimate> judge(const PoseEstimate& believed, Stamp stamp);
  /// Also kLost if the robot is lost in a map that is not searched, because it is too large or has
  /// too few landmarks, or because relocalisation.enabled is false.
  Belief belief() const { return unsearched_radius_ ? Belief::kLost : belief_; }
  /// The pose to be reported: while it is not trusted, its covariance covers the whole map.
  PoseEstimate told(PoseEstimate believed) const;
  /// While the pose is not trusted, a warning that says what the search is waiting for. Also a
  /// warning if the pose is trusted although nothing that the robot sees can confirm it.
  Status status() const;
  const Counters& counters() const { return counters_; }
  /// Has the robot be searched for by these landmarks of the back-end's map, too.
  friend void searchBy(Relocaliser& relocaliser, const LandmarkMap& landmarks) {
    relocaliser.doubt_.know(pointsOf(landmarks));
  }
  /// Whether the place where the robot was found may still be withdrawn.
  friend bool isTested(const Relocaliser& relocaliser) {
    return relocaliser.grid_ && isTesting(*relocaliser.grid_);
  }

  /// Whether the robot is lost since what its laser saw changed at once. The back-end is at a pose
  /// where the robot is not, so that it gets nothing.
  friend bool isCarriedAway(const Relocaliser& relocaliser) {
    return relocaliser.was_carried_ && relocaliser.belief_ != Belief::kSure;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(belief_, landmarks_, searches_landmarks_, searches_grid_, has_new_scan_,
            is_lost_by_scans_, is_grid_too_large_, sees_only_lines_, is_ambiguous_,
            unsearched_radius_, gating_, doubt_, scan_change_, changed_, was_carried_, counters_);
    if (grid_) archive(*grid_);
  }

 private:
  /// It tells by what a loss was noticed.
  enum class Cause { kLandmarks, kScans, kChange };

  Status unsearched(const MapState& loaded) const;
  std::string whyUnsearched() const;
  void watch(const Pose2& believed, Stamp stamp);
  /// @return nothing if neither landmarks nor scans contradict the map
  std::optional<Cause> contradiction() const;
  bool isAgreedAgain() const;
  void lose(const Pose2& believed, Cause cause);
  void heedChange(const LaserScan& changed, const Pose2& believed);
  bool isElsewhere(const LaserScan& changed, const Pose2& believed) const;
  void removeLandmarks(const std::vector<LandmarkId>& doubtful);
  bool isLostByScans() const;
  double radiusOfMap(const Pose2& believed) const;
  bool usesScans() const;
  bool begin(const MapState* loaded);
  LandmarkMap landmarksToSearch(const MapState* loaded) const;
  void end();
  void forgetSurroundings();
  std::optional<PoseEstimate> settle(const Recognition& found, const PoseEstimate& believed);
  std::optional<PoseEstimate> settleByScans(const Recognition& found, const PoseEstimate& believed);
  void believePlaceOfScans();
  void testPlace(const Pose2& believed);

  RelocalisationConfig config_;
  Capabilities capabilities_;
  Belief belief_ = Belief::kSure;
  LandmarkRecogniser landmarks_;
  std::optional<GridRecogniser> grid_;  ///< if the back-end has a grid
  bool searches_landmarks_ = false, searches_grid_ = false;
  bool has_new_scan_ = false;
  bool is_lost_by_scans_ = false;  ///< lost according to the scans, not to the landmarks
  bool is_grid_too_large_ = false;
  bool sees_only_lines_ = false;  ///< nothing can confirm a loaded pose
  bool is_ambiguous_ = false;     ///< the last search found several places
  /// The robot is lost and is not searched for: it is in a circle of this radius, which holds the
  /// map [m].
  std::optional<double> unsearched_radius_;
  GatingRate gating_{kWindow};  ///< of observations that are associated by id
  LocalLandmarks::Ids ids_ = LocalLandmarks::Ids::kKnown;
  LandmarkDoubt doubt_;
  ScanChange scan_change_;
  /// The scan of this step, if it shows that the robot was carried.
  std::optional<LaserScan> changed_;
  /// The scans have changed at once, and no place has been found and tested since.
  bool was_carried_ = false;
  Counters counters_;

  static constexpr int kWindow = 10;  ///< steps with known landmarks
};

}  // namespace slam::relocalisation
