// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/kld_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace slam::particle_filter {

double KldSize::neededFor(std::size_t bins) const {
  if (bins <= 1) return 1.0;
  const double k = static_cast<double>(bins - 1), a = 2.0 / (9.0 * k);
  const double root = 1.0 - a + std::sqrt(a) * limits_.quantile;
  return k / (2.0 * limits_.error) * root * root * root;
}

std::size_t KldSize::drawnFrom(const std::vector<Pose2>& poses, const std::vector<double>& weights,
                               RandomStream& random) const {
  std::vector<double> sums(weights.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) sums[i] = sum += weights[i];

  std::set<std::array<double, 3>> bins;
  const auto bin = [](double value, double width) { return std::round(value / width); };
  std::size_t drawn = 0;
  while (drawn < limits_.max) {
    const auto found = std::upper_bound(sums.begin(), sums.end(), sum * random.uniform());
    const auto i =
        std::min<std::size_t>(static_cast<std::size_t>(found - sums.begin()), poses.size() - 1);
    bins.insert({bin(poses[i].x(), limits_.bin_position), bin(poses[i].y(), limits_.bin_position),
                 bin(poses[i].theta(), limits_.bin_heading)});
    ++drawn;
    if (drawn >= limits_.min && static_cast<double>(drawn) >= neededFor(bins.size())) break;
  }
  return drawn;
}

}  // namespace slam::particle_filter
