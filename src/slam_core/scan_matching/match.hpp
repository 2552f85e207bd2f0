// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/scan_matching/agreement.hpp"

namespace slam::scan_matching {

/// The result of matching a scan with a map.
struct Match {
  Pose2 pose;                                             ///< T_map_base, from scan and prior
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of the pose, from the scan
  Agreement agreement;
  double prior_weight = 1.0;      ///< robust weight of the prior, 0 to 1; 0 after a search
  bool is_determined = false;     ///< enough ends fit the map
  bool was_searched = false;      ///< nothing fitted at the prior
  bool is_among_older = false;    ///< the prior was that among the older surfaces of the map
  bool wide_search_done = false;  ///< it may have found nothing
  /// Motion was missing for so long that the robot may be anywhere around; the scan was not
  /// matched.
  bool is_anywhere = false;
  /// The pose that a wide search found, relative to the prior's.
  std::optional<Pose2> jumped;
};

}  // namespace slam::scan_matching
