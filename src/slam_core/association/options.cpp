// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/options.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace slam::association {

void Options::gather(const LandmarkObservationArray& array, const CandidateSource& source,
                     double gate, double ring) {
  const auto& observations = array.observations;
  of_.resize(observations.size());
  is_near_.assign(observations.size(), 0);
  for (std::size_t i = 0; i < observations.size(); ++i) {
    candidates_.clear();
    source.candidates(i, candidates_);
    add(i, observations[i], gate, ring * ring * gate);
  }
}

void Options::add(std::size_t observation, const LandmarkObservation& z, double gate,
                  double ring_gate) {
  auto& options = of_[observation];
  options.clear();
  const double log_noise = std::log(z.covariance.determinant());
  for (const auto& [landmark, nu, S, descriptor_cost] : candidates_) {
    const double determinant = S.determinant();
    const double nis = nu.dot(S.inverse() * nu);
    const bool is_usable = determinant > 0.0 && nis >= 0.0 && std::isfinite(nis);
    // what cannot be compared is near: nothing is begun in doubt
    if (!is_usable || nis <= ring_gate) is_near_[observation] = 1;
    if (!is_usable || nis > gate) continue;
    const double spread = std::max(0.0, std::log(determinant) - log_noise);
    options.push_back(
        {landmark, nu, S, log_noise, nis + spread + descriptor_cost, descriptor_cost});
  }
  std::sort(options.begin(), options.end(), [](const Option& a, const Option& b) {
    return std::tie(a.cost, a.landmark) < std::tie(b.cost, b.landmark);
  });
}

Decision Options::unpaired(std::size_t observation, bool map_is_fixed) const {
  using Kind = Decision::Kind;
  if (is_near_[observation]) return {Kind::kAmbiguous, 0};
  return {map_is_fixed ? Kind::kNotInMap : Kind::kNew, 0};
}

bool Options::isAmbiguous(std::size_t observation, double margin) const {
  const auto& options = of_[observation];
  return options.size() > 1 && options[1].cost < options[0].cost + margin;
}

}  // namespace slam::association
