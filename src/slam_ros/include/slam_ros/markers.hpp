// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "slam_core/models/landmark_map.hpp"

namespace slam_ros {

/// For each point its 95 % ellipse, its position and its id, for each line the part that was seen
/// and its id. A map that lost landmarks must be preceded by clearMarkers().
visualization_msgs::MarkerArray toMarkers(const slam::LandmarkMap& landmarks,
                                          const std_msgs::Header& header);

visualization_msgs::Marker clearMarkers(const std_msgs::Header& header);

}  // namespace slam_ros
