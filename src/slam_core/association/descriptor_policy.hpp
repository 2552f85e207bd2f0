// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/jcbb.hpp"

namespace slam::association {

/// Jcbb among the landmarks whose descriptor fits the observation's by a chi-square test; how well
/// it fits is a part of the likelihood. Of observations and landmarks without a descriptor the
/// place alone decides. Registered as `descriptor`.
class DescriptorPolicy final : public AssociationPolicy {
 public:
  void configure(const PolicyConfig& config) override;
  bool usesPlaces() const override { return true; }
  void decide(const LandmarkObservationArray& array, const CandidateSource& source,
              bool map_is_fixed, std::vector<Decision>& decisions) override;

 private:
  double probability_ = 0.0;
  Jcbb jcbb_;
};

}  // namespace slam::association
