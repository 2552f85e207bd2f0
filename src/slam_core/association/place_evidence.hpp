// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/distrusted_ids.hpp"
#include "slam_core/association/existence.hpp"
#include "slam_core/association/line_trials.hpp"
#include "slam_core/association/trials.hpp"

namespace slam::association {

/// What tells landmarks from clutter where observations are associated by place: only what has
/// been on trial enters the map (Trials), and what is not there any more leaves it (Existence).
/// Lines have trials of their own and stay.
///
/// Call order in a step: move(), see(), hold() of the policy's decisions, then ghosts() after the
/// update. Where ids decide, it only holds what has an id that is distrusted.
class PlaceEvidence {
 public:
  PlaceEvidence() = default;
  /// @param map landmarks that were loaded
  explicit PlaceEvidence(const PlaceConfig& config, const LandmarkMap& map = {})
      : is_needed_(true),
        trials_(config.sightings),
        line_trials_(config.sightings),
        existence_(map) {}

  void move(const Motion& motion) {
    if (!is_needed_) return;
    trials_.move(motion);
    line_trials_.move(motion);
    existence_.move(motion);
  }
  void see(const LandmarkObservationArray& array);
  /// What is new is held back until it is confirmed.
  void hold(const LandmarkObservationArray& array, std::vector<Decision>& decisions) const;
  /// A landmark is to be re-initialised.
  /// @return whether it is to be removed instead, see DistrustedIds
  bool distrusts(LandmarkId id, bool was_confirmed) { return ids_.count(id, was_confirmed); }
  /// A landmark was removed on request: what is on trial starts over.
  void forget(LandmarkId id) {
    trials_.forget();
    line_trials_.forget();
    existence_.forget(id);
    ids_.forget(id);
  }
  /// @param sensor T_map_sensor
  /// @return landmarks to be removed
  std::vector<LandmarkId> ghosts(const Pose2& sensor, const std::vector<LandmarkPlace>& landmarks,
                                 const std::vector<LandmarkId>& seen) {
    if (!is_needed_) return {};
    return existence_.see(sensor, landmarks, seen, reach_);
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(is_line_, reach_, trials_, line_trials_, existence_, ids_);
  }

 private:
  bool is_needed_ = false;
  std::vector<bool> is_line_;  ///< by observation of the last array
  SensorReach reach_;
  Trials trials_{1};
  LineTrials line_trials_{1};
  Existence existence_;
  DistrustedIds ids_;
};

}  // namespace slam::association
