// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/candidates.hpp"

#include <cmath>

namespace slam::ekf {

LandmarksInView landmarksById(const LandmarkObservationArray& array, const EkfState& state) {
  LandmarksInView view;
  view.observations = static_cast<Eigen::Index>(array.observations.size());
  for (const auto& z : array.observations) {
    if (z.id == kUnknownId) continue;
    if (const auto landmark = state.find(z.id))
      view.landmarks.push_back(static_cast<Eigen::Index>(*landmark));
    else
      ++view.others;
  }
  return view;
}

LandmarksInView LandmarksByPlace::all() const {
  LandmarksInView view;
  view.observations = static_cast<Eigen::Index>(of.size());
  for (const auto& near : of) {
    view.landmarks.insert(view.landmarks.end(), near.begin(), near.end());
    view.others += near.empty() ? 1 : 0;
  }
  return view;
}

/// Robot and landmark may both be in doubt: relative to one another no more than both together.
LandmarksByPlace landmarksByPlace(const LandmarkObservationArray& array, const EkfState& state,
                                  const ObservationModel& model, double gate) {
  const auto map = state.map();
  const auto pose = state.pose();
  LandmarksByPlace result;
  for (const auto& z : array.observations) {
    auto& near = result.of.emplace_back();
    Eigen::Matrix<double, 2, 3> J_robot;
    Eigen::Matrix2d J_z;
    const Eigen::Vector2d place =
        model.invert(pose.pose, array.sensor_pose, z.vector(), &J_robot, &J_z);
    const double variance = (J_robot * pose.covariance * J_robot.transpose()).trace() +
                            (J_z * z.covariance * J_z.transpose()).trace();
    for (const auto& landmark : map) {
      const double sigma = std::sqrt(variance) + std::sqrt(landmark.covariance.trace());
      if ((landmark.position - place).squaredNorm() <= gate * sigma * sigma)
        near.push_back(static_cast<Eigen::Index>(*state.find(landmark.id)));
    }
  }
  return result;
}

Match PlaceCandidates::match(const association::Pairing& pairing) const {
  return {state_.slotOf(pairing.landmark), array_.observations[pairing.observation]};
}

void PlaceCandidates::candidates(std::size_t observation,
                                 std::vector<association::Candidate>& candidates) const {
  for (const auto landmark : near_.of[observation]) {
    const auto number = static_cast<std::size_t>(landmark);
    const std::vector<Match> one = {match({observation, number})};
    const auto predicted =
        model_.predict(state_.robot(), array_.sensor_pose, state_.point(one[0].slot).now);
    if (model_.isSingular(predicted)) continue;
    const ObservationUpdate update(model_, state_, array_.sensor_pose, one, 1);
    if (update.isSolved())
      candidates.push_back({number, update.innovation(0), update.covariance(0)});
  }
}

Eigen::Matrix2d PlaceCandidates::crossCovariance(const association::Pairing& first,
                                                 const association::Pairing& second) const {
  const std::vector<Match> both = {match(first), match(second)};
  const ObservationUpdate update(model_, state_, array_.sensor_pose, both, 1);
  if (!update.isSolved()) return Eigen::Matrix2d::Zero();
  return update.joint().S.topRightCorner<2, 2>();
}

}  // namespace slam::ekf
