// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam_ros {

/// Computes the NEES of poses against a true trajectory that is received meanwhile. The truth's
/// frame is aligned with the map's at the first pose for which both are known, without a fit.
class TruthComparison {
 public:
  /// The newest thousand poses are kept; if a stamp goes back, it starts over.
  void add(slam::Stamp stamp, const slam::Pose2& truth);
  /// Whether the truth of that stamp may still come.
  bool isExpected(slam::Stamp stamp) const;
  /// The NEES; 3 is expected. Nothing if the truth of that stamp has not come or has a gap there.
  std::optional<double> nees(slam::Stamp stamp, const slam::PoseEstimate& estimate);
  /// To be called when the map starts over.
  void reset() { T_map_truth_.reset(); }

 private:
  std::optional<slam::Pose2> truthAt(slam::Stamp stamp) const;

  std::map<slam::Stamp, slam::Pose2> truth_;
  std::optional<slam::Pose2> T_map_truth_;
};

}  // namespace slam_ros
