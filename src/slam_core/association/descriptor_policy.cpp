// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/descriptor_policy.hpp"

#include <algorithm>

#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::association {
namespace {

const Registrar<AssociationPolicy, DescriptorPolicy> kDescriptorRegistrar("descriptor");

/// The candidates of another source without those whose descriptor does not fit.
class FittingCandidates final : public CandidateSource {
 public:
  FittingCandidates(const LandmarkObservationArray& array, const CandidateSource& all,
                    double probability)
      : array_(array), all_(all), probability_(probability) {}

  std::size_t size() const override { return all_.size(); }
  std::optional<std::size_t> find(LandmarkId id) const override { return all_.find(id); }
  void candidates(std::size_t observation, std::vector<Candidate>& candidates) const override {
    const auto first = static_cast<std::ptrdiff_t>(candidates.size());
    all_.candidates(observation, candidates);
    const auto& seen = array_.observations[observation].descriptor;
    if (seen.isEmpty()) return;
    const auto fails = [&](Candidate& candidate) {
      const auto fit = fitOf(seen, all_.descriptor(candidate.landmark), probability_);
      candidate.descriptor_cost = fit.cost;
      return !fit.passes;
    };
    candidates.erase(std::remove_if(candidates.begin() + first, candidates.end(), fails),
                     candidates.end());
  }
  Eigen::Matrix2d crossCovariance(const Pairing& first, const Pairing& second) const override {
    return all_.crossCovariance(first, second);
  }

 private:
  const LandmarkObservationArray& array_;
  const CandidateSource& all_;
  double probability_;
};

}  // namespace

void DescriptorPolicy::configure(const PolicyConfig& config) {
  probability_ = config.gate_probability;
  jcbb_.configure(config);
}

void DescriptorPolicy::decide(const LandmarkObservationArray& array, const CandidateSource& source,
                              bool map_is_fixed, std::vector<Decision>& decisions) {
  jcbb_.decide(array, FittingCandidates(array, source, probability_), map_is_fixed, decisions);
}

}  // namespace slam::association
