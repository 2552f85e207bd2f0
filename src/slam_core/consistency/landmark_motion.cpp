// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/landmark_motion.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam {
namespace {

/// Where fewer landmarks are common to both ends, hardly anything shows whether they fit.
constexpr std::size_t kFewestCommon = 3;
constexpr double kPieceOfSensor = 1.0;  ///< of the way, at least [m]
constexpr double kOutOfView = 2.0;      ///< the landmarks have gone out of view by then [m]
/// The landmarks did not move as a rigid body where chi-square is so many times what it should be.
constexpr double kRigid = 9.0;

/// A landmark in the sensor's frame [m], with its covariance.
struct Place {
  Eigen::Vector2d position;
  Eigen::Matrix2d covariance;
};

struct Pair {
  Place begin, end;
};

Place placeOf(const LandmarkObservation& z) {
  const Eigen::Vector2d direction(std::cos(z.bearing), std::sin(z.bearing));
  Eigen::Matrix2d J;  // of the position with respect to range and bearing
  J.col(0) = direction;
  J.col(1) = z.range * Eigen::Vector2d(-direction.y(), direction.x());
  return {z.range * direction, J * z.covariance * J.transpose()};
}

std::vector<Pair> pairsOf(const LandmarkObservationArray& begin,
                          const LandmarkObservationArray& end) {
  std::vector<Pair> pairs;
  for (const auto& first : begin.observations) {
    const auto is_same = [&first](const auto& z) { return z.id == first.id && !z.isLine(); };
    const auto found = std::find_if(end.observations.begin(), end.observations.end(), is_same);
    if (first.id != kUnknownId && !first.isLine() && found != end.observations.end())
      pairs.push_back({placeOf(first), placeOf(*found)});
  }
  return pairs;
}

/// The motion of the sensor that explains the pairs best, and its covariance as a Motion has it.
struct Fit {
  Pose2 motion;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double chi_square = 0.0;
};

/// Gauss-Newton. An error of a landmark at the end counts as it appears at the beginning.
Fit fitted(const std::vector<Pair>& pairs, const Pose2& first_guess) {
  constexpr int kIterations = 5;
  Fit fit;
  fit.motion = first_guess;
  for (int i = 0; i < kIterations; ++i) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    fit.chi_square = 0.0;
    for (const auto& [begin, end] : pairs) {
      Eigen::Matrix<double, 2, 3> J;
      Eigen::Matrix2d R;
      const Eigen::Vector2d residual = begin.position - fit.motion.transform(end.position, &J, &R);
      const auto C = (begin.covariance + R * end.covariance * R.transpose()).llt();
      information += J.transpose() * C.solve(J);
      slope += J.transpose() * C.solve(residual);
      fit.chi_square += residual.dot(C.solve(residual));
    }
    fit.covariance = information.llt().solve(Eigen::Matrix3d::Identity());
    fit.motion = Pose2::fromVector(fit.motion.vector() + fit.covariance * slope);
  }
  return fit;
}

/// The way [m] relative to the mean of the headings at its two ends. On an arc it is forward,
/// however wrong the turn is. It gets the Jacobian with respect to (x, y, theta).
Eigen::Vector2d chordOf(const Pose2& motion, Eigen::Matrix<double, 2, 3>& J) {
  const Eigen::Matrix2d R = Pose2(0.0, 0.0, -0.5 * motion.theta()).rotation();
  const Eigen::Vector2d way = R * motion.position();
  J.leftCols<2>() = R;
  J.col(2) = 0.5 * Eigen::Vector2d(way.y(), -way.x());
  return way;
}

/// The odometry's increment as motion of the sensor.
Motion ofSensor(const Motion& odometry, const Pose2& begin_base_sensor,
                const Pose2& end_base_sensor) {
  Eigen::Matrix3d J_base, J_sensor;
  Motion motion = odometry;
  motion.increment = begin_base_sensor.inverse()
                         .compose(odometry.increment, nullptr, &J_base)
                         .compose(end_base_sensor, &J_sensor);
  const Eigen::Matrix3d J = J_sensor * J_base;
  motion.covariance = J * odometry.covariance * J.transpose();
  return motion;
}

/// Nothing where the landmarks, or odometry and landmarks, have no motion in common.
std::optional<PieceOfWay> compared(const Motion& odometry, const std::vector<Pair>& pairs) {
  constexpr double kOutOfScale = 0.6;
  const auto fit = fitted(pairs, odometry.increment);
  const double excess = fit.chi_square / (2.0 * static_cast<double>(pairs.size()) - 3.0);
  if (!fit.motion.isFinite() || !(excess < kRigid)) return std::nullopt;
  PieceOfWay piece;
  Eigen::Matrix<double, 2, 3> J_odometry, J_fit;
  piece.odometry = chordOf(odometry.increment, J_odometry);
  piece.estimated = chordOf(fit.motion, J_fit);
  piece.covariance = J_odometry * odometry.covariance * J_odometry.transpose() +
                     std::max(1.0, excess) * J_fit * fit.covariance * J_fit.transpose();
  const double larger = std::max(piece.odometry.norm(), piece.estimated.norm());
  const bool fits = (piece.odometry - piece.estimated).norm() < kOutOfScale * larger &&
                    piece.covariance.allFinite();
  return fits ? std::optional(piece) : std::nullopt;
}

}  // namespace

std::optional<PieceOfWay> LandmarkMotion::see(const LandmarkObservationArray& array) {
  if (array.observations.size() < kFewestCommon) return std::nullopt;
  std::optional<PieceOfWay> piece;
  if (begin_ && odometry_) {
    const auto motion = ofSensor(*odometry_, begin_->sensor_pose, array.sensor_pose);
    const double way = motion.increment.position().norm();
    if (way < kPieceOfSensor) return std::nullopt;
    const auto pairs = pairsOf(*begin_, array);
    if (pairs.size() < kFewestCommon && way < kOutOfView) return std::nullopt;
    if (pairs.size() >= kFewestCommon) piece = compared(motion, pairs);
  }
  begin_ = array;
  odometry_.reset();
  return piece;
}

}  // namespace slam
