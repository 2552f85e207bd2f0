// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/association_policy.hpp"

namespace slam::association {

/// Observations say of which landmark they are. Of two of one id in an array the first counts; one
/// without an id is clutter.
class KnownIds final : public AssociationPolicy {
 public:
  bool usesPlaces() const override { return false; }
  void decide(const LandmarkObservationArray& array, const CandidateSource& source,
              bool map_is_fixed, std::vector<Decision>& decisions) override;

 private:
  void findRepeated(const std::vector<LandmarkObservation>& observations);

  std::vector<std::size_t> order_;  ///< of the observations by id
  std::vector<char> is_repeated_;   ///< by observation
};

}  // namespace slam::association
