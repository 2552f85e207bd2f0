// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam::fiducial {

/// What the coordinator of every marker detector needs: the markers (robot file) and when to reject
/// one (product file).
struct FiducialConfig {
  static constexpr const char* kSection = "fiducial";

  double marker_size = 0.16;
  std::map<std::int64_t, double> marker_sizes;
  std::vector<std::int64_t> ids;
  double corner_sigma = 0.2;
  double sigma_range_relative = 0.01;

  double min_side = 12.0;
  double max_obliqueness = 1.3;
  double border = 3.0;
  double max_reprojection_error = 2.0;
  double max_relative_sigma = 0.1;

  void describe(Fields& fields);
  /// The side of a marker [m]; the offset of its family is included in the id.
  double sizeOf(LandmarkId id) const;
  bool isListed(LandmarkId id) const;
};

}  // namespace slam::fiducial
