// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <utility>
#include <vector>

#include "slam_core/models/landmark_map.hpp"

namespace slam_ros {

/// Draws the 95 % ellipse, the position and the id of each point, and the seen part and the id of
/// each line.
visualization_msgs::MarkerArray toMarkers(const slam::LandmarkMap& landmarks,
                                          const std_msgs::Header& header);

/// Makes the markers of a map, message after message. A message deletes all earlier markers if one
/// of them is of a landmark that the map no longer holds. So does the first message, since earlier
/// markers are of a product that ran before.
class LandmarkMarkers {
 public:
  /// @param landmarks sorted by id
  visualization_msgs::MarkerArray next(const slam::LandmarkMap& landmarks,
                                       const std_msgs::Header& header);

 private:
  using Shown = std::vector<std::pair<slam::LandmarkId, slam::LandmarkKind>>;

  std::optional<Shown> shown_;  ///< in the message before, sorted
};

}  // namespace slam_ros
