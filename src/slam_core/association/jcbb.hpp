// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/joint_search.hpp"
#include "slam_core/association/options.hpp"
#include "slam_core/association/unmapped_rivals.hpp"

namespace slam::association {

/// Joint compatibility branch and bound (Neira, Tardos 2001): observations of a stamp are paired so
/// that all innovations together are likely, which they are not where the pose's error would have
/// to differ from one to the other. What is paired with another landmark in a hypothesis that is
/// nearly as likely is left out; so is clutter, and what may as well be of a landmark that is not
/// in the map yet (UnmappedRivals). Ids are not looked at.
///
/// Many observations are paired in groups, one after the other.
class Jcbb final : public AssociationPolicy {
 public:
  void configure(const PolicyConfig& config) override;
  bool usesPlaces() const override { return true; }
  void decide(const LandmarkObservationArray& array, const CandidateSource& source,
              bool map_is_fixed, std::vector<Decision>& decisions) override;

 private:
  void pairGroup(const LandmarkObservationArray& array, const CandidateSource& source,
                 std::vector<Decision>& decisions);

  double gate_ = 0.0;
  PlaceConfig places_;
  Options options_;
  JointSearch search_;
  UnmappedRivals rivals_;
  std::vector<JointSearch::Choice> choices_;  ///< of a group
  std::vector<std::size_t> group_;            ///< observations
  std::vector<std::size_t> taken_;            ///< landmarks that the groups before are paired with
};

}  // namespace slam::association
