// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>

namespace slam::mono_graph {

/// 256 comparisons of grays around a feature (ORB: Rublee et al. 2011).
using Descriptor = std::array<std::uint64_t, 4>;

/// Hamming's distance: how many comparisons differ.
inline int distanceOf(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < a.size(); ++i) distance += __builtin_popcountll(a[i] ^ b[i]);
  return distance;
}

}  // namespace slam::mono_graph
