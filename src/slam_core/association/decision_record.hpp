// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/contract/landmark_mapper.hpp"

namespace slam::association {

/// The reason under which an observation that is clutter is counted: "duplicate", "unknown_id",
/// "not_in_map", "ambiguous", "on_trial", "distrusted_id".
std::string reasonOf(Decision::Kind kind);

/// What the decisions of a step took the observations for, without the landmarks' ids.
std::vector<AssociatedObservation> recordOf(const LandmarkObservationArray& array,
                                            const std::vector<Decision::Kind>& kinds);

/// Gives the new landmarks of a record their ids, one after the other. An empty record stays so.
class NewLandmarks {
 public:
  explicit NewLandmarks(std::vector<AssociatedObservation>& record) : record_(record) {}

  /// Goes on to the next observation that is new.
  void next() {
    do ++place_;
    while (place_ < record_.size() && record_[place_].taken_for != TakenFor::kNew);
  }
  void setId(LandmarkId id) {
    if (place_ < record_.size()) record_[place_].landmark = id;
  }

 private:
  std::vector<AssociatedObservation>& record_;
  std::size_t place_ = static_cast<std::size_t>(-1);
};

}  // namespace slam::association
