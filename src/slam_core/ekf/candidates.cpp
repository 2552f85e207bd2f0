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

namespace {

/// Where an observation puts a landmark, and how far it may be off.
struct Placed {
  Eigen::Vector2d m;
  Eigen::Matrix2d P;
};

Placed placed(const ObservationModel& model, const LandmarkObservation& z, const PoseEstimate& pose,
              const Pose2& sensor) {
  Eigen::Matrix<double, 2, 3> J_robot;
  Eigen::Matrix2d J_z;
  Placed result;
  result.m = model.invert(pose.pose, sensor, z.vector(), &J_robot, &J_z);
  result.P = J_robot * pose.covariance * J_robot.transpose() + J_z * z.covariance * J_z.transpose();
  return result;
}

/// Robot and landmark may both be in doubt: relative to one another no more than both together.
bool isNear(const Placed& place, const Landmark& point, double gate) {
  const double sigma = std::sqrt(place.P.trace()) + std::sqrt(point.covariance.trace());
  return (point.position - place.m).squaredNorm() <= gate * sigma * sigma;
}

/// The same of a line, which has to be seen where it is known to be, too.
bool isNear(const LandmarkObservation& z, const Landmark& line, const PoseEstimate& pose,
            const Pose2& sensor, double gate) {
  const LineModel model(line.position);
  const Eigen::Vector2d known(0.0, line.direction);
  const auto place = placed(model, z, pose, sensor);
  const Eigen::Vector2d off = model.innovation(place.m, known);
  const Eigen::Vector2d sigma =
      place.P.diagonal().cwiseSqrt() + line.covariance.diagonal().cwiseSqrt();
  const double along = std::sqrt(gate * pose.covariance.topLeftCorner<2, 2>().trace());
  return (off.cwiseAbs2().array() <= gate * sigma.cwiseAbs2().array()).all() &&
         gapBetween(model.extentOf(pose.pose * sensor, z, known), line.extent) <=
             kLargestLineGap + along;
}

}  // namespace

LandmarksByPlace landmarksByPlace(const LandmarkObservationArray& array, const EkfState& state,
                                  const ObservationModel& model, double gate) {
  const auto map = state.boundedMap();
  const auto pose = state.pose();
  LandmarksByPlace result;
  for (const auto& z : array.observations) {
    auto& near = result.of.emplace_back();
    const auto place = placed(model, z, pose, array.sensor_pose);
    for (const auto& landmark : map) {
      if (landmark.isLine() != z.isLine()) continue;
      if (z.isLine() ? isNear(z, landmark, pose, array.sensor_pose, gate)
                     : isNear(place, landmark, gate))
        near.push_back(static_cast<Eigen::Index>(*state.find(landmark.id)));
    }
  }
  return result;
}

namespace {

Eigen::Matrix<double, 2, 6> jacobianOf(const Innovation& innovation) {
  Eigen::Matrix<double, 2, 6> H;
  H << innovation.H_robot, innovation.H_heading, innovation.H_landmark;
  return H;
}

Eigen::Matrix2d crossOf(const DenseCovariance& P, const Innovation& first,
                        const Innovation& second) {
  return jacobianOf(first) * observedOf(P, first.slot, second.slot) *
         jacobianOf(second).transpose();
}

}  // namespace

PlaceCandidates::PlaceCandidates(const LandmarkObservationArray& array, const EkfState& state,
                                 const ObservationModel& model, const LandmarksByPlace& near,
                                 const association::DescriptorMap& descriptors)
    : IdCandidates(state), descriptors_(descriptors), near_(array.observations.size()) {
  const auto& robot = state.robot();
  for (std::size_t i = 0; i < near_.size(); ++i)
    for (const auto landmark : near.of[i]) {
      const auto number = static_cast<std::size_t>(landmark);
      const auto slot = state.slotOf(number);
      const auto point = state.point(slot);
      const auto& of_kind = point.modelOr(model);
      if (of_kind.isSingular(of_kind.predict(robot, array.sensor_pose, point.now))) continue;
      near_[i].push_back(
          {number, state.innovation({model, robot, array.sensor_pose, point, array.observations[i]},
                                    observedOf(state.covariance(), slot, slot))});
      near_[i].back().innovation.slot = slot;
    }
}

void PlaceCandidates::candidates(std::size_t observation,
                                 std::vector<association::Candidate>& candidates) const {
  for (const auto& [landmark, z] : near_[observation])
    candidates.push_back({landmark, z.nu, crossOf(state_.covariance(), z, z) + z.R});
}

const Innovation* PlaceCandidates::find(const association::Pairing& pairing) const {
  for (const auto& [landmark, innovation] : near_[pairing.observation])
    if (landmark == pairing.landmark) return &innovation;
  return nullptr;
}

Eigen::Matrix2d PlaceCandidates::crossCovariance(const association::Pairing& first,
                                                 const association::Pairing& second) const {
  const auto *a = find(first), *b = find(second);
  if (a == nullptr || b == nullptr) return Eigen::Matrix2d::Zero();
  return crossOf(state_.covariance(), *a, *b);
}

}  // namespace slam::ekf
