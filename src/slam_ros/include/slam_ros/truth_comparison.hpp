// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam_ros {

/// NEES of poses against a true trajectory that comes beside them. The truth's frame is brought
/// onto the map's where both are known for the first time: no fit.
class TruthComparison {
 public:
  /// The newest thousand are kept; a stamp that goes back starts over.
  void add(slam::Stamp stamp, const slam::Pose2& truth);
  /// Whether there is hope that the truth of that stamp is still on its way.
  bool isExpected(slam::Stamp stamp) const;
  /// 3 expected; nothing where the truth has not come as far or has a gap there.
  std::optional<double> nees(slam::Stamp stamp, const slam::PoseEstimate& estimate);
  /// The map started over.
  void reset() { T_map_truth_.reset(); }

 private:
  std::optional<slam::Pose2> truthAt(slam::Stamp stamp) const;

  std::map<slam::Stamp, slam::Pose2> truth_;
  std::optional<slam::Pose2> T_map_truth_;
};

}  // namespace slam_ros
