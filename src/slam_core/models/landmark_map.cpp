// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_map.hpp"

#include <algorithm>

namespace slam {

PoseEstimate bounded(PoseEstimate estimate, const Eigen::Vector3d& largest_sigmas) {
  const Eigen::Vector3d sigma = estimate.covariance.diagonal().cwiseSqrt();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (sigma(i) <= largest_sigmas(i)) continue;
    estimate.covariance.row(i) *= largest_sigmas(i) / sigma(i);
    estimate.covariance.col(i) *= largest_sigmas(i) / sigma(i);
  }
  return estimate;
}

LandmarkMap pointsOf(LandmarkMap map) {
  const auto is_line = [](const Landmark& landmark) { return landmark.isLine(); };
  map.erase(std::remove_if(map.begin(), map.end(), is_line), map.end());
  return map;
}

MapState withoutLines(const MapState& map) {
  MapState points = map;
  points.landmarks = pointsOf(map.landmarks);
  if (points.landmarks.size() == map.landmarks.size()) return points;
  std::vector<Eigen::Index> rows = {0, 1, 2};
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    const auto row = 3 + 2 * static_cast<Eigen::Index>(i);
    if (!map.landmarks[i].isLine()) rows.insert(rows.end(), {row, row + 1});
  }
  if (map.joint_covariance.size() == 0) return points;
  const auto size = static_cast<Eigen::Index>(rows.size());
  points.joint_covariance.resize(size, size);
  for (Eigen::Index column = 0; column < size; ++column)
    for (Eigen::Index row = 0; row < size; ++row)
      points.joint_covariance(row, column) = map.joint_covariance(
          rows[static_cast<std::size_t>(row)], rows[static_cast<std::size_t>(column)]);
  return points;
}

}  // namespace slam
