// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/camera/ceiling_view.hpp"
#include "slam_core/ceiling_features/ceiling_features_config.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam::ceiling_features {

/// Range and bearing of the point of the ceiling that a pixel sees, from the point right above the
/// camera, with bearing 0 along the robot's x axis, and their covariance by the pixel's noise and
/// the ceiling's. It has no id and no descriptor. Nothing where the pixel sees no ceiling.
std::optional<LandmarkObservation> observationOf(const Eigen::Vector2d& pixel,
                                                 const CeilingView& ceiling,
                                                 const CeilingFeaturesConfig& config);

}  // namespace slam::ceiling_features
