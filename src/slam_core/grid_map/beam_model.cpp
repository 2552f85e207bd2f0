// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/beam_model.hpp"

#include <algorithm>
#include <cmath>

namespace slam::grid_map {
namespace {

int logOddsOf(double probability) {
  return static_cast<int>(std::lround(kLogOddsUnit * std::log(probability / (1.0 - probability))));
}

}  // namespace

BeamModel::BeamModel(const GridMapConfig& config)
    : resolution_(config.resolution),
      usable_range_(config.usable_range),
      free_range_(std::min(config.free_range, config.usable_range)),
      hit_(static_cast<LogOdds>(std::clamp(logOddsOf(config.hit_probability), 1, 127))),
      largest_(static_cast<LogOdds>(std::clamp(logOddsOf(config.largest_probability), 1, 127))),
      reach_(static_cast<int>(std::ceil(2.5 * config.sigma / config.resolution))) {
  const int miss = std::min(-1, logOddsOf(config.miss_probability));
  for (int old = -128; old <= 127; ++old) {
    const int before = old == kUnseen ? 0 : old;
    const auto cell = index(static_cast<LogOdds>(old));
    after_miss_[cell] =
        static_cast<LogOdds>(std::clamp(before + miss, -int{largest_}, int{largest_}));
  }
  for (int cells = -reach_; cells <= reach_; ++cells)
    for (int offset = -kOffsets / 2; offset < kOffsets / 2; ++offset) {
      const double d =
          (cells - static_cast<double>(offset) / kOffsets) * resolution_ / config.sigma;
      kernel_.push_back(static_cast<float>(std::exp(-0.5 * d * d)));
    }
}

LogOdds BeamModel::gainOf(double sigma) const {
  const double share = 0.5 * resolution_ / std::max(kSigmas * sigma, 0.5 * resolution_);
  return static_cast<LogOdds>(std::max(1l, std::lround(share * share * hit_)));
}

}  // namespace slam::grid_map
