// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/feature_selection.hpp"

#include <algorithm>
#include <cmath>

namespace slam::ceiling_features {
namespace {

/// How much more distinct than its neighbours a landmark has to be: noise must not change the
/// order.
constexpr double kLead = 1.15;

/// Whether the image holds all that is within the spacing of a point: something more distinct may
/// be just outside of it.
bool isWholeInImage(const Eigen::Vector2d& point, double spacing, const CeilingView& ceiling,
                    const cv::Size& size) {
  constexpr int kDirections = 8;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * M_PI * i / kDirections;
    const auto pixel =
        ceiling.toPixel(point + spacing * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    if (!pixel || pixel->x() < 0.0 || pixel->y() < 0.0 || pixel->x() > size.width - 1 ||
        pixel->y() > size.height - 1)
      return false;
  }
  return true;
}

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
    else if (!isWholeInImage(feature.point, spacing, ceiling, size))
      feature.rejection = "cut_off";
    else if (++chosen > config.max_features)
      feature.rejection = "too_many";
  }
  return features;
}

}  // namespace slam::ceiling_features
