// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>

namespace slam {

/// A counter-based random stream (Philox 4x32-10; Salmon et al., SC 2011), named by
/// (seed, step, particle): the numbers do not depend on who draws first or on which thread.
/// The distributions are our own, since those of the standard library differ between vendors.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t step, std::uint32_t particle = 0);

  std::uint32_t bits();
  double uniform();   ///< in [0, 1)
  double gaussian();  ///< mean 0, variance 1 (Box-Muller)

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 4> block_{};
  unsigned used_ = 4;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace slam
