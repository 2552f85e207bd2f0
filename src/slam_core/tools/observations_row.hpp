// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include "log_rows.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// "observations STAMP_NS [ID RANGE BEARING]..." [m, rad], sorted by id; the noise is the robot
/// file's.
inline LandmarkObservationArray observationsIn(LogRows& row) {
  LandmarkObservationArray array;
  array.stamp = stampFromNanoseconds(row.integer());
  while (row.hasMore()) {
    LandmarkObservation z;
    z.id = row.integer();
    z.range = row.number();
    z.bearing = row.number();
    z.covariance(0, 0) = -1.0;  // the robot file's
    array.observations.push_back(z);
  }
  std::stable_sort(array.observations.begin(), array.observations.end(),
                   [](const auto& a, const auto& b) { return a.id < b.id; });
  return array;
}

}  // namespace slam
