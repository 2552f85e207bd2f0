// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::particle_filter {

/// How many particles are enough that their histogram over poses is nearer to the true density than
/// `error` (Kullback-Leibler) with a given probability (Fox 2003).
class KldSize {
 public:
  struct Limits {
    std::size_t min = 1, max = 1;
    double error = 0.05;         ///< epsilon
    double quantile = 2.33;      ///< z of the normal distribution at the wanted probability
    double bin_position = 0.05;  ///< [m]
    double bin_heading = 0.05;   ///< [rad]
  };

  explicit KldSize(const Limits& limits) : limits_(limits) {}

  /// Draws from the weighted poses until there are as many as the bins they fall into ask for.
  std::size_t drawnFrom(const std::vector<Pose2>& poses, const std::vector<double>& weights,
                        RandomStream& random) const;

  /// The number that `bins` occupied bins ask for, Fox 2003, Eq. 7; not limited.
  double neededFor(std::size_t bins) const;

 private:
  Limits limits_;
};

}  // namespace slam::particle_filter
