// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/visual_odometry/point_match.hpp"

namespace slam::visual_odometry {

/// reference = scale * R(theta) * now + t
struct Similarity {
  double scale = 1.0;
  Pose2 T_reference_now;
};

/// Weighted least squares in closed form (Umeyama 1991, in the plane). @pre two matches or more
Similarity fitSimilarity(const PointMatches& matches);

/// The same with the scale fixed to 1.
Pose2 fitRigid(const PointMatches& matches);

/// What the matches leave over: reference - T now, in units of their sigma, root mean square for
/// each direction. @pre two matches or more
double residualSigma(const PointMatches& matches, const Pose2& T_reference_now);

/// Covariance of (x, y, theta) of the rigid fit when the sigmas are right [m^2, m rad, rad^2].
Eigen::Matrix3d rigidCovariance(const PointMatches& matches, const Pose2& T_reference_now);

}  // namespace slam::visual_odometry
