// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/resampling.hpp"

namespace slam::particle_filter {

std::vector<std::uint32_t> SystematicResampling::draw(const std::vector<double>& weights,
                                                      std::size_t count,
                                                      RandomStream& random) const {
  const double offset = random.uniform(), n = static_cast<double>(count);
  std::vector<double> positions(count);
  for (std::size_t k = 0; k < count; ++k) positions[k] = (static_cast<double>(k) + offset) / n;
  return particlesAt(positions, weights);
}

}  // namespace slam::particle_filter
