// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/consistency/gating_rate.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/relocalisation/grid_recogniser.hpp"
#include "slam_core/relocalisation/landmark_doubt.hpp"
#include "slam_core/relocalisation/landmark_recogniser.hpp"

namespace slam::relocalisation {

/// How much the pose of a back-end is believed.
enum class Belief {
  kSure,         ///< nothing speaks against it
  kUnconfirmed,  ///< it came with a map that was loaded, of which nothing has been recognised yet
  kLost,         ///< what is seen contradicts the map around it
  kAnywhere      ///< somebody has asked to look for the robot in the whole map
};

/// Judges whether a robot is where its back-end has it, and finds it in the back-end's map where it
/// is not: by the landmarks around it, or by what its laser has seen on the last metres. It needs
/// nothing of a back-end but its map and its innovations, so that it serves all of them.
///
/// Who calls: the Estimator. After configure(), for each step the motions and what was seen; after
/// the back-end's own step judge(). Counted: "withheld" (observations that the back-end did not
/// get), "relocalised".
class Relocaliser {
 public:
  /// @param capabilities of the back-end, which outlives this @param ids whether those of
  /// observations are those of the map @throw ConfigError
  void configure(Settings& settings, const Capabilities& capabilities, LocalLandmarks::Ids ids);
  void reset();

  /// The robot was put somewhere, or a map was loaded, or somebody is in doubt. A map that holds
  /// nothing to recognise a place by leaves the pose believed.
  /// @param loaded the map that the back-end was just given, to save asking it for a copy
  /// @return a warning where the pose is believed since the grid is too large to be searched
  Status assume(Belief belief, const MapState* loaded = nullptr);
  /// The grid is searched with the next scan, also where the robot stands still.
  void searchAnyway();

  void predict(const Motion& motion);
  /// @return whether the back-end may have it too: from a wrong pose it would put new landmarks,
  /// or walls, at wrong places
  bool see(const LandmarkObservationArray& array);
  bool see(const LaserScan& scan);

  /// @return where the robot is, where that is not where the back-end has it
  std::optional<PoseEstimate> judge(const PoseEstimate& believed, Stamp stamp);
  Belief belief() const { return belief_; }
  /// The pose with all the doubt there is: while it is not believed, somewhere in the map.
  PoseEstimate told(PoseEstimate believed) const;
  /// A warning that says what it waits for, while the pose is not believed.
  Status status() const;
  const Counters& counters() const { return counters_; }

 private:
  void watch(const Pose2& believed, Stamp stamp);
  bool isLostByScans() const;
  bool begin(const MapState* loaded);
  LandmarkMap landmarksToSearch(const MapState* loaded) const;
  void end();
  void forgetSurroundings();
  std::optional<PoseEstimate> settle(const Recognition& found, const PoseEstimate& believed);

  RelocalisationConfig config_;
  Capabilities capabilities_;
  Belief belief_ = Belief::kSure;
  LandmarkRecogniser landmarks_;
  std::optional<GridRecogniser> grid_;  ///< where the back-end has a grid
  bool searches_landmarks_ = false, searches_grid_ = false;
  bool is_lost_by_scans_ = false;  ///< and not by landmarks
  bool is_grid_too_large_ = false;
  bool is_ambiguous_ = false;   ///< the last search found several places
  GatingRate gating_{kWindow};  ///< of observations that are known by their ids
  LandmarkDoubt doubt_;         ///< of those that are associated by place
  Counters counters_;

  static constexpr int kWindow = 10;  ///< steps with known landmarks
};

}  // namespace slam::relocalisation
