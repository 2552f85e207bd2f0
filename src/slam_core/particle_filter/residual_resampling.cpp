// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "slam_core/particle_filter/resampling.hpp"

namespace slam::particle_filter {

std::vector<std::uint32_t> ResidualResampling::draw(const std::vector<double>& weights,
                                                    std::size_t count, RandomStream& random) const {
  std::vector<std::uint32_t> drawn;
  drawn.reserve(count);
  std::vector<double> rest(weights.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double expected = static_cast<double>(count) * weights[i];
    const double certain = std::floor(expected);
    drawn.insert(drawn.end(), static_cast<std::size_t>(certain), static_cast<std::uint32_t>(i));
    sum += rest[i] = expected - certain;
  }
  if (drawn.size() >= count) {  // rounding may make one too many of whole parts
    drawn.resize(count);
    return drawn;
  }
  for (auto& weight : rest) weight /= sum;
  const auto others = MultinomialResampling().draw(rest, count - drawn.size(), random);
  drawn.insert(drawn.end(), others.begin(), others.end());
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

}  // namespace slam::particle_filter
