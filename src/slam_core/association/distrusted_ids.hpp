// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/common/status.hpp"

namespace slam::association {

/// Ids that do not name one place: of several markers that have the same id, or of none that is
/// there, which a detector reads by mistake. A landmark with such an id is re-initialised again and
/// again. Each time costs it trust, more where it had been confirmed in the place before, and from
/// some point on its id is not used any more. One marker that is moved now and then keeps its id.
///
/// Call order in a step: refuse() of the policy's decisions; after the update count() for each
/// landmark that is to be re-initialised.
class DistrustedIds {
 public:
  /// The observations of distrusted ids become clutter.
  void refuse(const LandmarkObservationArray& array, std::vector<Decision>& decisions) const;
  /// Counts that a landmark was found elsewhere.
  /// @param was_confirmed whether it had been seen several times where the map has it
  /// @return whether its id is distrusted from now on; then it is to be removed
  bool count(LandmarkId id, bool was_confirmed);
  bool has(LandmarkId id) const;
  /// The id is trusted as if it had never been seen.
  void forget(LandmarkId id) { doubts_.erase(id); }

  static Status warningOf(LandmarkId id);

  template <class Archive>
  void persist(Archive& archive) {
    archive(doubts_);
  }

 private:
  std::map<LandmarkId, int> doubts_;
};

}  // namespace slam::association
