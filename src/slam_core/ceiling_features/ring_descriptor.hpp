// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/camera/ceiling_view.hpp"
#include "slam_core/ceiling_features/scaled_image.hpp"
#include "slam_core/models/descriptor.hpp"

namespace slam::ceiling_features {

/// It describes what surrounds a point of the ceiling: on rings about it, mean and standard
/// deviation of the logarithm of the brightness, the means relative to that of all rings. It does
/// not depend on the heading of the robot, nor on how much light there is (as the spin images of
/// Lazebnik, Schmid, Ponce 2005).
/// @param radius of the outermost ring [m]
/// @return nothing where the image does not hold all of the rings
std::optional<Descriptor> describeSurroundings(const ScaledImage& image, const cv::Size& size,
                                               const CeilingView& view,
                                               const Eigen::Vector2d& point, double radius);

}  // namespace slam::ceiling_features
