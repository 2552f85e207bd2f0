// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/camera/ceiling_view.hpp"
#include "slam_core/ceiling_features/ceiling_features_config.hpp"
#include "slam_core/ceiling_features/scaled_image.hpp"

namespace slam::ceiling_features {

/// A spot of the ceiling, and what became of it.
struct CeilingFeature {
  Spot spot;
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< on the ceiling, in the base frame [m]
  std::string rejection;                            ///< empty where it is a landmark
};

/// Chooses landmarks among the spots of an image so that another image of the same ceiling yields
/// the same ones. The reasons of rejections are those of CeilingFeatures.
/// @param spots most distinct first; those that see no ceiling are left out
/// @param size of the image
std::vector<CeilingFeature> selectFeatures(const std::vector<Spot>& spots, const cv::Size& size,
                                           const CeilingView& ceiling,
                                           const CeilingFeaturesConfig& config);

}  // namespace slam::ceiling_features
