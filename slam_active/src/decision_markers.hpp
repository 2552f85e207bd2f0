// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "slam_core/active_path/explorer.hpp"

namespace slam_active {

/// For rviz: the frontiers as points, the candidates as arrows that are the longer the more they
/// gain per metre of way, and the goal as a green one, orange where it closes a loop. It takes the
/// place of the array before.
visualization_msgs::MarkerArray toMarkers(const slam::active_path::Decision& decision,
                                          double resolution, const std_msgs::Header& header);

}  // namespace slam_active
