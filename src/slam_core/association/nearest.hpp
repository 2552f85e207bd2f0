// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/options.hpp"

namespace slam::association {

/// An observation is of the landmark that it is most likely of, on its own, where no other
/// observation is more likely of that one: the individual compatibility nearest neighbour
/// (Bar-Shalom, Fortmann 1988), mutual. Where a second landmark or a second observation is nearly
/// as likely, it is left out. Ids are not looked at.
class Nearest final : public AssociationPolicy {
 public:
  void configure(const PolicyConfig& config) override;
  bool usesPlaces() const override { return true; }
  void decide(const LandmarkObservationArray& array, const CandidateSource& source,
              bool map_is_fixed, std::vector<Decision>& decisions) override;

 private:
  /// An observation that may be of a landmark.
  struct Claim {
    std::size_t landmark;
    double cost;
    std::size_t observation;
  };
  void collectClaims();
  void grant(std::vector<Decision>& decisions) const;

  double gate_ = 0.0;
  PlaceConfig places_;
  Options options_;
  std::vector<Claim> claims_;  ///< by landmark, the most likely one first
};

}  // namespace slam::association
