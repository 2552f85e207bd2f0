// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/genealogy.hpp"

#include <algorithm>
#include <cmath>

namespace slam::particle_filter {

void Genealogy::weigh(double effective, std::size_t count) {
  const auto all = static_cast<double>(count);
  alive_ = count < 2 ? 0.0 : std::clamp((1.0 - 1.0 / effective) / (1.0 - 1.0 / all), 0.0, 1.0);
}

void Genealogy::resample(const std::vector<std::uint32_t>& ancestors) {
  if (ancestors.size() < 2) return;
  alive_ = 1.0;
  std::vector<double> offspring(1 + *std::max_element(ancestors.begin(), ancestors.end()));
  for (const auto ancestor : ancestors) offspring[ancestor] += 1.0;
  const auto count = static_cast<double>(ancestors.size());
  double pairs = 0.0;
  for (const double children : offspring) pairs += children * (children - 1.0);
  constexpr double kAll = 0.999999;
  coalesced_ -= std::log1p(-std::min(kAll, pairs / (count * (count - 1.0))));
}

double Genealogy::forgottenSince(double time) const {
  return 1.0 - alive_ * std::exp(time - coalesced_);
}

}  // namespace slam::particle_filter
