// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/candidates.hpp"

#include <cmath>

namespace slam::landmark_graph {

PlaceCandidates::PlaceCandidates(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                                 const association::DescriptorMap& descriptors, double gate,
                                 const Viewpoint& from)
    : IdCandidates(graph), descriptors_(descriptors) {
  findNear(array, gate, sensorOf(graph, array.sensor_pose, from));
  prediction_.emplace(graph, array.sensor_pose, matches_, from);
}

/// Sensor and landmark may both be in doubt: relative to one another no more than both together.
void PlaceCandidates::findNear(const LandmarkObservationArray& array, double gate,
                               const PoseEstimate& sensor) {
  const double scale_variance = rangeScaleVarianceOf(graph_);
  const RangeBearingModel model;
  const auto map = graph_.map();
  const auto order = graph_.ids().order();
  for (const auto& z : array.observations) {
    first_.push_back(matches_.size());
    ObservationModel::Jacobian23 J_sensor;
    Eigen::Matrix2d J_z;
    const Eigen::Vector2d place = model.invert(sensor.pose, Pose2(), z.vector(), &J_sensor, &J_z);
    const double variance = (J_sensor * sensor.covariance * J_sensor.transpose()).trace() +
                            (J_z * z.covariance * J_z.transpose()).trace() +
                            z.range * z.range * scale_variance;
    for (std::size_t k = 0; k < map.size(); ++k) {
      const double sigma = std::sqrt(variance) + std::sqrt(map[k].covariance.trace());
      if ((map[k].position - place).squaredNorm() <= gate * sigma * sigma)
        matches_.push_back({order[k], z});
    }
  }
  first_.push_back(matches_.size());
}

void PlaceCandidates::candidates(std::size_t observation,
                                 std::vector<association::Candidate>& candidates) const {
  for (auto i = first_[observation]; i < first_[observation + 1]; ++i)
    if (!prediction_->isSingular(i))
      candidates.push_back(
          {matches_[i].landmark, prediction_->innovation(i), prediction_->covariance(i)});
}

std::size_t PlaceCandidates::matchOf(const association::Pairing& pairing) const {
  auto match = first_[pairing.observation];
  while (matches_[match].landmark != pairing.landmark) ++match;
  return match;
}

Eigen::Matrix2d PlaceCandidates::crossCovariance(const association::Pairing& first,
                                                 const association::Pairing& second) const {
  return prediction_->crossCovariance(matchOf(first), matchOf(second));
}

}  // namespace slam::landmark_graph
