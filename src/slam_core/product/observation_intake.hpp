// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <unordered_set>

#include "slam_core/common/counters.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/landmark_sensor.hpp"

namespace slam {

/// What the Estimator lets through to its back-end of an observation array. The work of a step
/// grows with the cube of the observations and its memory with the square of the map, so that one
/// wild array could stop a robot. A descriptor that cannot be used is left out and the observation
/// stays. Counted: "invalid_observation", "invalid_descriptor", "line_observation",
/// "observations_beyond_limit", "new_landmarks_beyond_limit".
class ObservationIntake {
 public:
  static constexpr std::size_t kMostObservations = 500;  ///< of one array
  static constexpr std::size_t kMostNewLandmarks = 200;  ///< of one step

  /// @param takes_lines the back-end maps lines; else they are left out
  /// @param needs_ids observations are associated by their ids; where none has one, a warning says
  /// so
  explicit ObservationIntake(const LandmarkSensorConfig& sensor = {}, bool takes_lines = false,
                             bool needs_ids = false)
      : sensor_(sensor), takes_lines_(takes_lines), misses_ids_(needs_ids) {}

  /// When an array arrives: fills in the sensor's covariances, leaves out what is invalid or beyond
  /// kMostObservations, corrects what the robot file says of the sensor, and sorts by id.
  /// @return what was left out and why, or that no observation has an id; empty where all is well
  std::string screen(LandmarkObservationArray& array, Counters& counters);

  /// When a step takes the array: leaves out new landmarks beyond kMostNewLandmarks. They come with
  /// a later array. @return as screen()
  std::string admit(LandmarkObservationArray& array, Counters& counters);

  /// The landmarks of a map are not new; those that were admitted before are. Descriptors may have
  /// another length from then on.
  void knowOnly(const LandmarkMap& map);

  template <class Archive>
  void persist(Archive& archive) {
    archive(misses_ids_, arrays_without_id_, known_, descriptor_size_);
  }

 private:
  std::string watchIds(const std::vector<LandmarkObservation>& all);

  LandmarkSensorConfig sensor_;
  bool takes_lines_;
  bool misses_ids_;                       ///< they are needed, and no observation had one so far
  std::size_t arrays_without_id_ = 0;     ///< of those that hold observations
  std::unordered_set<LandmarkId> known_;  // looked up only, never iterated
  Eigen::Index descriptor_size_ = 0;      ///< of all, as the first one has it; 0 before that
};

}  // namespace slam
