// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "log_rows.hpp"
#include "motion_row.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam {

/// "odometry STAMP_NS X Y THETA": the pose in the odometry frame [m, m, rad].
inline OdometrySample odometryIn(LogRows& row) {
  OdometrySample sample;
  sample.stamp = stampFromNanoseconds(row.integer());
  sample.pose = poseIn(row);
  return sample;
}

}  // namespace slam
