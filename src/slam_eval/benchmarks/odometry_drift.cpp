// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "odometry_drift.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam::eval {
namespace {

/// Way and angle from the first pose to each.
void travelled(const std::vector<Pose2>& poses, std::vector<double>& way,
               std::vector<double>& angle) {
  way.assign(1, 0.0);
  angle.assign(1, 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Pose2 step = poses[i - 1].between(poses[i]);
    way.push_back(way.back() + step.position().norm());
    angle.push_back(angle.back() + std::abs(step.theta()));
  }
}

Pose2 errorOver(const OdometryTrack& track, std::size_t from, std::size_t to) {
  const Pose2 truth = track.truth[from].between(track.truth[to]);
  return truth.between(track.odometry[from].between(track.odometry[to]));
}

struct Mean {
  double sum = 0.0, max = 0.0;
  int count = 0;
  void add(double value) {
    sum += value;
    max = std::max(max, value);
    ++count;
  }
  double mean() const { return sum / count; }
};

/// The first pose at least `piece` after pose `from`; the size where there is none.
std::size_t after(const std::vector<double>& travelled, std::size_t from, double piece) {
  const auto found = std::lower_bound(travelled.begin() + static_cast<std::ptrdiff_t>(from),
                                      travelled.end(), travelled[from] + piece);
  return static_cast<std::size_t>(found - travelled.begin());
}

}  // namespace

nlohmann::json driftOf(const OdometryTrack& track, double length, double angle) {
  std::vector<double> way, turned;
  travelled(track.truth, way, turned);
  Mean translation, rotation, turning;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (const auto end = after(way, i, length); end < way.size()) {
      const Pose2 error = errorOver(track, i, end);
      translation.add(error.position().norm() / (way[end] - way[i]));
      rotation.add(std::abs(error.theta()) / (way[end] - way[i]));
    }
    if (const auto end = after(turned, i, angle);
        end < turned.size() && way[end] - way[i] < 0.01 * (turned[end] - turned[i]))
      turning.add(std::abs(errorOver(track, i, end).theta()) / (turned[end] - turned[i]));
  }
  nlohmann::json result;
  if (translation.count > 0)
    result = {{"translation", translation.mean()},
              {"translation_max", translation.max},
              {"rotation_rad_per_m", rotation.mean()},
              {"rotation_rad_per_m_max", rotation.max}};
  if (turning.count > 0) {
    result["turning"] = turning.mean();
    result["turning_max"] = turning.max;
  }
  const Pose2 last = errorOver(track, 0, track.truth.size() - 1);
  result["end_m"] = last.position().norm();
  result["end_rad"] = std::abs(last.theta());
  return result;
}

double normalisedError(const OdometryTrack& track, std::size_t steps) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i + steps < track.truth.size(); i += steps) {
    Pose2 pose;
    Eigen::Matrix3d P = Eigen::Matrix3d::Zero(), J_pose, J_step;
    for (std::size_t k = i; k < i + steps; ++k) {
      pose = pose.compose(track.motions[k].increment, &J_pose, &J_step);
      P = J_pose * P * J_pose.transpose() +
          J_step * track.motions[k].covariance * J_step.transpose();
    }
    const Pose2 truth = track.truth[i].between(track.truth[i + steps]);
    const Eigen::Vector3d error(pose.x() - truth.x(), pose.y() - truth.y(),
                                wrapAngle(pose.theta() - truth.theta()));
    sum += error.dot(P.inverse() * error) / 3.0;
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace slam::eval
