// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "loop_world.hpp"
#include "slam_core/common/random.hpp"

namespace slam::eval {

/// A field of point landmarks, which a robot drives over lane by lane, so that from each lane it
/// sees some of the landmarks that it saw from the one before. Motion and observations have exactly
/// the noise that they claim.
struct FieldWorldConfig {
  int landmarks = 10000;
  double spacing = 3.0;           ///< of the landmarks [m]
  double lane = 0.0;              ///< length of a lane [m]; 0: the field is a square
  double between = 6.0;           ///< distance of two lanes [m]
  double view_range = 6.0;        ///< [m], all around
  double step_length = 0.25;      ///< way between two observations [m]
  double sigma_range = 0.1;       ///< [m]
  double sigma_bearing = 0.02;    ///< [rad]
  double sigma_position = 0.005;  ///< of a step, along and across [m]
  double sigma_heading = 0.001;   ///< of a step [rad]
};

/// The steps of one seed, one after the other.
class FieldWorld {
 public:
  FieldWorld(const FieldWorldConfig& config, std::uint64_t seed);
  /// @return nothing at the end of the last lane
  std::optional<LoopStep> next();

 private:
  double height() const;
  Pose2 trueStep();
  Motion measured(const Pose2& true_step);
  LandmarkObservationArray observed();

  FieldWorldConfig config_;
  RandomStream random_;
  int columns_ = 1;  ///< of landmarks along a lane
  std::vector<Eigen::Vector2d> places_;
  Pose2 start_, at_;  ///< in the field: of the beginning, and now
  int count_ = 0;
  double way_ = 0.0;  ///< driven in this lane, or between two
  bool is_in_lane_ = true, turns_left_ = true;
};

}  // namespace slam::eval
