// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/feature_selection.hpp"

#include <algorithm>

#include "slam_core/ceiling_features/ring.hpp"

namespace slam::ceiling_features {
namespace {

/// A landmark is so many times as distinct as its neighbours, so that noise does not change their
/// order.
constexpr double kLead = 1.15;

bool isDistinct(const CeilingFeature& feature, const std::vector<CeilingFeature>& all,
                double spacing) {
  const auto competes = [&](const CeilingFeature& other) {
    return &other != &feature && kLead * other.spot.contrast > feature.spot.contrast &&
           (other.point - feature.point).squaredNorm() < spacing * spacing;
  };
  return std::none_of(all.begin(), all.end(), competes);
}

std::vector<CeilingFeature> onCeiling(const std::vector<Spot>& spots, const CeilingView& ceiling) {
  std::vector<CeilingFeature> features;
  for (const auto& spot : spots)
    if (const auto point = ceiling.toCeiling(spot.pixel)) features.push_back({spot, *point, ""});
  return features;
}

}  // namespace

std::vector<CeilingFeature> selectFeatures(const std::vector<Spot>& spots, const cv::Size& size,
                                           const CeilingView& ceiling,
                                           const CeilingFeaturesConfig& config) {
  auto features = onCeiling(spots, ceiling);
  const double spacing = config.spacing * ceiling.height();
  const double min_range = config.min_range * ceiling.height();
  int chosen = 0;
  for (auto& feature : features) {
    if (!isDistinct(feature, features, spacing))
      feature.rejection = "not_distinct";
    else if ((feature.point - ceiling.origin()).norm() < min_range)
      feature.rejection = "too_near";
    else if (!pixelsOfRing(ceiling, feature.point, spacing, size))
      feature.rejection = "cut_off";  // something more distinct may be just outside of the image
    else if (++chosen > config.max_features)
      feature.rejection = "too_many";
  }
  return features;
}

}  // namespace slam::ceiling_features
