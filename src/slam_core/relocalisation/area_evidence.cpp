// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/area_evidence.hpp"

#include <cmath>

namespace slam::relocalisation {
namespace {

/// Edge of an area [patches].
constexpr int kAreaEdge = 6;
/// Probability that a place that looks alike up to an area looks alike in that one, too.
constexpr double kGoesOnAlike = 0.25;

std::pair<int, int> areaOf(const std::pair<int, int>& patch) {
  const auto divided = [](int i) {
    return static_cast<int>(std::floor(static_cast<double>(i) / kAreaEdge));
  };
  return {divided(patch.first), divided(patch.second)};
}

/// A place that looks alike is a mixture: it either goes on alike in the area, where all is as
/// likely as in the right place, or the area is independent.
double ofArea(double log_ratio) {
  return -std::log(kGoesOnAlike + (1.0 - kGoesOnAlike) * std::exp(-log_ratio));
}

}  // namespace

double AreaEvidence::add(const Patch& patch, double log_ratio) {
  double& sum = areas_[areaOf(patch)];
  const double before = ofArea(sum);
  sum += log_ratio;
  return ofArea(sum) - before;
}

}  // namespace slam::relocalisation
