// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/mono_graph/place_recogniser.hpp"
#include "slam_core/mono_graph/visual_map.hpp"

namespace slam::mono_graph {

/// A keyframe shows the place of an earlier one.
struct Loop {
  int earlier = 0, later = 0;
  Pose2 measured;              ///< T_earlier_later
  Eigen::Matrix3d covariance;  ///< of its coordinates
  bool is_believed = false;
  double weight = 1.0;    ///< where it is believed
  bool is_alone = false;  ///< it waits for another one that says the same

  template <class Archive>
  void persist(Archive& archive) {
    archive(earlier, later, measured, covariance, is_believed, weight, is_alone);
  }
};

/// The pose graph over keyframes (the essential graph of Mur-Artal et al. 2015, VII.D): those that
/// share points are joined as they lie, and loops of which any may be false pull at them
/// (graph::RobustLoops).
class LoopCloser {
 public:
  /// Loops that are believed from now on.
  struct Closed {
    int loops;       ///< one that waited may be among them
    bool is_newest;  ///< the newest is among them
  };

  /// A loop from a recognised place to a keyframe. Where it makes a loop believed, all keyframes
  /// are moved, each point with its host.
  Closed close(VisualMap& map, const RecognisedPlace& place, int keyframe);

  const std::vector<Loop>& loops() const { return loops_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(loops_);
  }

 private:
  std::vector<Loop> loops_;
};

/// The recognised points are those of the keyframe from now on, and neighbours see them, too.
void joinPlaces(VisualMap& map, const RecognisedPlace& place, int keyframe);

}  // namespace slam::mono_graph
