// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/particle_filter/particles/kld_size.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"
#include "slam_core/particle_filter/particles/random_streams.hpp"
#include "slam_core/particle_filter/particles/resampling.hpp"
#include "slam_core/particle_filter/particles/weights.hpp"

namespace slam::particle_filter {

/// When particles are drawn anew by their weights, how many, and which.
class Resampler {
 public:
  struct Config {
    std::string method = "systematic";
    double threshold = 0.75;               ///< share of effective particles below which it is done
    std::optional<KldSize::Limits> sizes;  ///< where the number follows the spread of the poses
  };

  Resampler() : Resampler(Config()) {}
  explicit Resampler(const Config& config);

  bool isDue(const Weights& weights) const;
  /// @param moments of the proposals by the weights
  /// @return for each new particle its ancestor
  std::vector<std::uint32_t> draw(const std::vector<PoseGaussian>& proposals,
                                  const Weights& weights, const PoseEstimate& moments,
                                  const RandomStreams& streams) const;

 private:
  double threshold_;
  std::unique_ptr<Resampling> resampling_;
  std::optional<KldSize> size_;
};

}  // namespace slam::particle_filter
