// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace slam::mono_graph {

/// 256 comparisons of grays around a feature (ORB: Rublee et al. 2011).
using Descriptor = std::array<std::uint64_t, 4>;

/// Hamming's distance: how many comparisons differ. Bits are counted in all words at once, since
/// the processors that are built for have no instruction for it.
inline int distanceOf(const Descriptor& a, const Descriptor& b) {
  constexpr std::uint64_t kPairs = 0x5555555555555555, kFours = 0x3333333333333333,
                          kBytes = 0x0f0f0f0f0f0f0f0f, kWords = 0x00ff00ff00ff00ff,
                          kOnes = 0x0001000100010001;
  std::uint64_t in_bytes = 0;  // at most 32 each
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::uint64_t x = a[i] ^ b[i];
    x -= (x >> 1) & kPairs;
    x = (x & kFours) + ((x >> 2) & kFours);
    in_bytes += (x + (x >> 4)) & kBytes;
  }
  const std::uint64_t in_words = (in_bytes & kWords) + ((in_bytes >> 8) & kWords);
  return static_cast<int>((in_words * kOnes) >> 48);
}

/// The candidate whose descriptor is nearest, and the distances of the nearest and the second one.
struct BestMatch {
  std::size_t candidate = 0;
  int distance = 257, second = 257;  ///< further than any

  void consider(std::size_t another, int its_distance) {
    if (its_distance < distance) {
      second = distance;
      distance = its_distance;
      candidate = another;
    } else if (its_distance < second) {
      second = its_distance;
    }
  }
  /// Whether it is near enough, and so much nearer than the second one.
  bool isClear(int largest_distance, double ratio) const {
    return distance <= largest_distance && distance <= ratio * second;
  }
};

}  // namespace slam::mono_graph
