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

/// For each point its 95 % ellipse, its position and its id, for each line the part that was seen
/// and its id.
visualization_msgs::MarkerArray toMarkers(const slam::LandmarkMap& landmarks,
                                          const std_msgs::Header& header);

/// The markers of a map, message after message. A message clears all before it where one of them is
/// of a landmark that the map no longer holds. So does the first one: they are of a product that
/// ran before.
class LandmarkMarkers {
 public:
  /// @param landmarks sorted by id
  visualization_msgs::MarkerArray next(const slam::LandmarkMap& landmarks,
                                       const std_msgs::Header& header);

 private:
  using Shown = std::vector<std::pair<slam::LandmarkId, slam::LandmarkKind>>;

  std::optional<Shown> shown_;  ///< by the message before, sorted
};

}  // namespace slam_ros
