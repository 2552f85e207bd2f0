// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/local_landmarks.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::relocalisation {
namespace {

constexpr double kSameGate = 13.8;          // 0.999 of chi-square with two degrees of freedom
constexpr double kVagueSigma = 0.5;         // a landmark that is less certain is forgotten [m]
constexpr std::size_t kMostLandmarks = 40;  // landmarks; the oldest are forgotten first
/// The errors of successive sightings are correlated: any number of sightings counts as four at
/// most. The variance of a Kalman filter converges to a quarter of a sighting's if this share of
/// the latter is added before each update.
constexpr double kInCommon = 1.0 / 12.0;

double distanceBetween(const LocalLandmark& a, const LocalLandmark& b) {
  const Eigen::Vector2d d = a.position - b.position;
  return d.dot((a.covariance + b.covariance).inverse() * d);
}

void fuse(LocalLandmark& known, const LocalLandmark& seen) {
  const Eigen::Matrix2d P = known.covariance + kInCommon * seen.covariance;
  const Eigen::Matrix2d K = P * (P + seen.covariance).inverse();
  known.position += K * (seen.position - known.position);
  const Eigen::Matrix2d fused = P - K * P;
  known.covariance = 0.5 * (fused + fused.transpose());
  association::fuse(seen.descriptor, known.descriptor);
}

}  // namespace

LocalLandmark localised(const LandmarkObservation& z, const Pose2& sensor_pose) {
  LocalLandmark seen;
  Eigen::Matrix2d J_z;
  seen.position = RangeBearingModel().invert({}, sensor_pose, z.vector(), nullptr, &J_z);
  seen.covariance = J_z * z.covariance * J_z.transpose();
  seen.descriptor = z.descriptor;
  return seen;
}

void move(const Motion& motion, std::vector<LocalLandmark>& landmarks) {
  Eigen::Matrix3d J_inverse;
  const Pose2 back = motion.increment.inverse(&J_inverse);
  const Eigen::Matrix3d Q = J_inverse * motion.covariance * J_inverse.transpose();
  for (auto& landmark : landmarks) {
    Eigen::Matrix<double, 2, 3> J_motion;
    Eigen::Matrix2d J_position;
    landmark.position = back.transform(landmark.position, &J_motion, &J_position);
    landmark.covariance = J_position * landmark.covariance * J_position.transpose() +
                          J_motion * Q * J_motion.transpose();
  }
}

void LocalLandmarks::move(const Motion& motion) {
  relocalisation::move(motion, landmarks_);
  const auto is_vague = [](const LocalLandmark& landmark) {
    return !(landmark.covariance.trace() < kVagueSigma * kVagueSigma);
  };
  landmarks_.erase(std::remove_if(landmarks_.begin(), landmarks_.end(), is_vague),
                   landmarks_.end());
}

bool LocalLandmarks::see(const LandmarkObservationArray& array) {
  bool has_new = false;
  for (const auto& z : array.observations) {
    if (z.isLine()) continue;  // a line has no position
    auto seen = localised(z, array.sensor_pose);
    if (ids_ == Ids::kKnown) seen.id = z.id;
    if (seen.position.allFinite() && seen.covariance.trace() < kVagueSigma * kVagueSigma)
      has_new |= see(seen);
  }
  return has_new;
}

/// A sighting with a known id but at another position is another landmark: two markers may have the
/// same id.
bool LocalLandmarks::see(const LocalLandmark& seen) {
  LocalLandmark* nearest = nullptr;
  double least = kSameGate;
  for (auto& known : landmarks_) {
    if (known.id != seen.id) continue;
    const double distance = distanceBetween(known, seen);
    if (distance >= least) continue;
    least = distance;
    nearest = &known;
  }
  if (nearest != nullptr) {
    fuse(*nearest, seen);
    return false;
  }
  if (landmarks_.size() == kMostLandmarks) landmarks_.erase(landmarks_.begin());
  landmarks_.push_back(seen);
  return true;
}

}  // namespace slam::relocalisation
