// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/association/local_landmark.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::relocalisation {

using association::LocalLandmark;

/// The landmarks around the robot, from what it has seen on the last metres of its way: a picture
/// that needs no map and no pose, and that can be looked for in a map.
class LocalLandmarks {
 public:
  enum class Ids { kKnown, kIgnored };

  explicit LocalLandmarks(Ids ids = Ids::kKnown) : ids_(ids) {}

  /// The robot moves; what it has seen stays behind and becomes less certain.
  void move(const Motion& motion);
  /// @return whether one of the landmarks is new
  bool see(const LandmarkObservationArray& array);
  void forget() { landmarks_.clear(); }

  /// In the order in which they were first seen.
  const std::vector<LocalLandmark>& all() const { return landmarks_; }

 private:
  bool see(const LocalLandmark& seen);

  Ids ids_;
  std::vector<LocalLandmark> landmarks_;
};

}  // namespace slam::relocalisation
