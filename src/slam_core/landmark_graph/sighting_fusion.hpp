// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::landmark_graph {

/// Two observations of one landmark as one by the second sensor pose: their mean, weighted with
/// their information. The sensor poses are near each other, in any common frame.
/// @return nothing where the first one puts the landmark into the second sensor, from where it has
/// no bearing
std::optional<LandmarkObservation> fused(const LandmarkObservation& a, const Pose2& sensor_a,
                                         const LandmarkObservation& b, const Pose2& sensor_b);

}  // namespace slam::landmark_graph
