// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QLineF>
#include <QPointF>
#include <cstddef>
#include <optional>
#include <vector>

namespace slam_rviz_plugins {

/// Where a landmark is drawn in the window [px]: from end to end of the part of a wall that was
/// seen, or with both ends at a point.
struct LandmarkPlace {
  std::size_t index = 0;  ///< of the landmark in its message
  QLineF line;
};

/// The index of the landmark that is drawn nearest to the mouse, the first one of equal distances.
/// @param reach how far off the mouse may be [px]
std::optional<std::size_t> nearestTo(const QPointF& mouse, const std::vector<LandmarkPlace>& places,
                                     double reach);

}  // namespace slam_rviz_plugins
