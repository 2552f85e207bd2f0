// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/mono_graph/bundle.hpp"
#include "slam_core/mono_graph/visual_map.hpp"

namespace slam::mono_graph {

/// Makes the map around the newest keyframe (Mur-Artal et al. 2015, VI): new points that few
/// images show are removed, and more are triangulated.
class LocalMapper {
 public:
  /// To be called when a keyframe was added, with its sightings of known points.
  void map(VisualMap& map);

  template <class Archive>
  void persist(Archive& archive) {
    archive(recent_);
  }

 private:
  struct Recent {
    int point = 0, host = 0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(point, host);
    }
  };

  void cull(VisualMap& map, int newest);
  void addPoints(VisualMap& map, int newest);

  std::vector<Recent> recent_;  ///< points that have not proved themselves yet
};

/// Looks for points in keyframes that do not see them yet; a feature that is of another point makes
/// both one.
void joinPoints(VisualMap& map, const std::vector<int>& points, const std::vector<int>& keyframes);
/// Adjusts a keyframe with those that share most points with it, their points, and odometry.
/// @param window how many keyframes are adjusted at once
void adjustAround(VisualMap& map, int keyframe, int window);

}  // namespace slam::mono_graph
