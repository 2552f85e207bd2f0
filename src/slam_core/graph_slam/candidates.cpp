// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/candidates.hpp"

#include <cmath>

#include "slam_core/graph_slam/prediction.hpp"

namespace slam::graph_slam {

/// Robot and landmark may both be in doubt: relative to one another no more than both together.
PlaceCandidates::PlaceCandidates(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                                 double gate)
    : IdCandidates(graph), array_(array), near_(array.observations.size()) {
  const RangeBearingModel model;
  const auto robot = graph.robot();
  const auto map = graph.map();
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const auto& z = array.observations[i];
    ObservationModel::Jacobian23 J_robot;
    Eigen::Matrix2d J_z;
    const Eigen::Vector2d place =
        model.invert(robot.pose, array.sensor_pose, z.vector(), &J_robot, &J_z);
    const double variance = (J_robot * robot.covariance * J_robot.transpose()).trace() +
                            (J_z * z.covariance * J_z.transpose()).trace();
    for (const auto& landmark : map) {
      const double sigma = std::sqrt(variance) + std::sqrt(landmark.covariance.trace());
      if ((landmark.position - place).squaredNorm() <= gate * sigma * sigma)
        near_[i].push_back(*graph.ids().find(landmark.id));
    }
  }
}

void PlaceCandidates::candidates(std::size_t observation,
                                 std::vector<association::Candidate>& candidates) const {
  std::vector<Match> matches;
  for (const auto landmark : near_[observation])
    matches.push_back({landmark, array_.observations[observation]});
  const Prediction prediction(graph_, array_.sensor_pose, matches);
  for (std::size_t i = 0; i < matches.size(); ++i)
    if (!prediction.isSingular(i))
      candidates.push_back(
          {matches[i].landmark, prediction.innovation(i), prediction.covariance(i)});
}

Eigen::Matrix2d PlaceCandidates::crossCovariance(const association::Pairing& first,
                                                 const association::Pairing& second) const {
  const std::vector<Match> both = {match(first), match(second)};
  const Prediction prediction(graph_, array_.sensor_pose, both);
  if (prediction.isSingular(0) || prediction.isSingular(1)) return Eigen::Matrix2d::Zero();
  return prediction.crossCovariance(0, 1);
}

}  // namespace slam::graph_slam
