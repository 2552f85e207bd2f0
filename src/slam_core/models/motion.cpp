// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace slam {
namespace {

constexpr double kFastest = 100.0;     // [m/s]
constexpr double kLyingStamps = 10.0;  // [m]
constexpr double kFarthestPose = 1e9;  // of odometry from its origin [m]
constexpr double kAtTheOrigin = 0.05;  // [m], [rad]; a restarted robot may have begun to move

bool isNear(const Pose2& pose) { return pose.position().cwiseAbs().maxCoeff() <= kFarthestPose; }

}  // namespace

std::pair<Motion, Motion> split(const Motion& motion, Stamp at) {
  const double share = seconds(at - motion.start) / seconds(motion.end - motion.start);
  Motion before = motion, after = motion;
  before.end = after.start = at;
  before.increment = motion.increment.part(share);
  after.increment = before.increment.between(motion.increment);
  before.covariance = share * motion.covariance;
  after.covariance = (1.0 - share) * motion.covariance;
  // the driver's own path, of which the increment may be a calibrated version
  const Pose2 driven = motion.odometry_start.between(motion.odometry_end);
  before.odometry_end = after.odometry_start = motion.odometry_start * driven.part(share);
  return {before, after};
}

/// Each pair of elements is compared by the standard deviations that it belongs to: norms of huge
/// elements would overflow, and a test by them would pass.
bool isCovariance(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  constexpr double kSymmetry = 1e-6;
  if (!matrix.allFinite()) return false;
  const Eigen::VectorXd sigma = matrix.diagonal().cwiseAbs().cwiseSqrt();
  const Eigen::MatrixXd most = kSymmetry * sigma * sigma.transpose();
  if (!((matrix - matrix.transpose()).cwiseAbs().array() <= most.array()).all()) return false;
  return Eigen::LLT<Eigen::MatrixXd>(matrix).info() == Eigen::Success;
}

Motion joined(const Motion& first, const Motion& second) {
  Eigen::Matrix3d J_first, J_second;
  Motion motion = second;
  motion.start = first.start;
  motion.odometry_start = first.odometry_start;
  motion.increment = first.increment.compose(second.increment, &J_first, &J_second);
  motion.covariance = J_first * first.covariance * J_first.transpose() +
                      J_second * second.covariance * J_second.transpose();
  return motion;
}

std::string faultOf(const Motion& motion) {
  const bool finite = motion.increment.isFinite() && motion.odometry_start.isFinite() &&
                      motion.odometry_end.isFinite() && motion.covariance.allFinite();
  if (!finite) return "motion holds a value that is not a number";
  if (motion.end <= motion.start) return "motion ends before it starts";
  if (!isNear(motion.odometry_start) || !isNear(motion.odometry_end))
    return fmt::format("motion's odometry pose is more than {:g} m from its origin", kFarthestPose);
  if (!isPossible(motion.increment, motion.end - motion.start))
    return fmt::format("motion tells of {:.3g} m within {:.3g} s, which no robot drives",
                       motion.increment.position().stableNorm(),
                       seconds(motion.end - motion.start));
  if (!isCovariance(motion.covariance)) return "motion's covariance is not positive definite";
  const Eigen::Vector3d sigma = motion.covariance.diagonal().cwiseSqrt();
  if (sigma.head<2>().maxCoeff() > kLargestInputSigmaLength || sigma.z() > kLargestInputSigmaAngle)
    return fmt::format(
        "motion has standard deviations of {:.3g} m, {:.3g} m and {:.3g} rad, more than {:g} m or "
        "{:g} rad",
        sigma.x(), sigma.y(), sigma.z(), kLargestInputSigmaLength, kLargestInputSigmaAngle);
  return "";
}

bool isPossible(const Pose2& step, Duration interval) {
  return step.position().stableNorm() <= kFastest * seconds(interval) + kLyingStamps;
}

bool isOrigin(const Pose2& pose) { return pose.vector().cwiseAbs().maxCoeff() <= kAtTheOrigin; }

}  // namespace slam
