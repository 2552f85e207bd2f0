// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam::eval {

/// The rigid motion of the plane that brings the positions of the poses nearest to those of others
/// (Umeyama 1991). @pre as many poses as others
Pose2 alignment(const std::vector<Pose2>& poses, const std::vector<Pose2>& others);

/// Root mean square distance of the positions after this motion [m].
double positionError(const std::vector<Pose2>& poses, const std::vector<Pose2>& truth);

}  // namespace slam::eval
