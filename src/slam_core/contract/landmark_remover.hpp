// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/status.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// The capability of a back-end that removes a landmark from its map on request, such as one that
/// does not exist.
///
/// Who calls: the Estimator, between two steps.
class LandmarkRemover {
 public:
  virtual ~LandmarkRemover() = default;
  /// From now on the landmark is in no map, and no observation is associated with it. Landmarks on
  /// trial start over, so that the landmark does not come back with the next observation. If the
  /// back-end associates by ids, the next observation of this id adds a new landmark.
  /// @return an error if the landmark is not in the map or the map is fixed; then nothing changes
  virtual Status remove(LandmarkId id) = 0;
};

/// Whether a landmark can be removed.
inline Status removalOf(LandmarkId id, bool is_in_map, bool map_is_fixed) {
  if (map_is_fixed)
    return Status::error(
        "the map is fixed in the mode localization: remove the landmark while mapping, or from the "
        "map's file");
  if (is_in_map) return Status::ok();
  return Status::error("there is no landmark " + std::to_string(id) +
                       " in the map: the topic `landmarks` shows the ids");
}

}  // namespace slam
