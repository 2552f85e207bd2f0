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

/// The landmark that an observation of a point describes, in the robot's frame, without its id.
LocalLandmark localised(const LandmarkObservation& z, const Pose2& sensor_pose);
/// Moves landmarks into the robot's new frame, in which they are less certain.
void move(const Motion& motion, std::vector<LocalLandmark>& landmarks);

/// A local map of the landmarks that the robot has seen on the last metres. It needs neither a map
/// nor a pose, and can be searched for in a map.
class LocalLandmarks {
 public:
  enum class Ids { kKnown, kIgnored };

  explicit LocalLandmarks(Ids ids = Ids::kKnown) : ids_(ids) {}

  /// Moves the landmarks into the robot's new frame, in which they are less certain.
  void move(const Motion& motion);
  /// @return whether one of the landmarks is new
  bool see(const LandmarkObservationArray& array);
  void forget() { landmarks_.clear(); }

  /// In the order in which they were first seen.
  const std::vector<LocalLandmark>& all() const { return landmarks_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(landmarks_);
  }

 private:
  bool see(const LocalLandmark& seen);

  Ids ids_;
  std::vector<LocalLandmark> landmarks_;
};

}  // namespace slam::relocalisation
