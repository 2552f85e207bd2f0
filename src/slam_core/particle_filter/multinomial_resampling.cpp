// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "slam_core/particle_filter/resampling.hpp"

namespace slam::particle_filter {

std::vector<std::uint32_t> MultinomialResampling::draw(const std::vector<double>& weights,
                                                       std::size_t count,
                                                       RandomStream& random) const {
  std::vector<double> positions(count);
  for (auto& position : positions) position = random.uniform();
  std::sort(positions.begin(), positions.end());
  return particlesAt(positions, weights);
}

}  // namespace slam::particle_filter
