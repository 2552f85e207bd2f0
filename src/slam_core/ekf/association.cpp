// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/association.hpp"

#include <Eigen/LU>
#include <cmath>
#include <set>

namespace slam::ekf {

/// The quantile of the chi-square distribution with two degrees of freedom has a closed form.
KnownIdAssociation::KnownIdAssociation(double gate_probability)
    : gate_(-2.0 * std::log(1.0 - gate_probability)) {}

Association KnownIdAssociation::associate(const LandmarkObservationArray& array,
                                          const EkfState& state, const ObservationModel& model,
                                          const Linearization& linearization,
                                          Counters& counters) const {
  Association association;
  std::set<LandmarkId> seen;
  for (const auto& z : array.observations) {
    if (z.id == kUnknownId) {
      ++association.unknown;
      continue;
    }
    if (!seen.insert(z.id).second) {
      counters.add("duplicate");
      continue;
    }
    const auto landmark = state.find(z.id);
    if (!landmark) {
      association.unseen.push_back(z);
      continue;
    }
    const auto m_map = state.landmark(*landmark);
    if (model.isSingular(model.predict(state.robot(), array.sensor_pose, m_map))) {
      ++association.gated;
      continue;
    }
    auto innovation = linearization.innovation(model, state.robot(), array.sensor_pose, m_map, z);
    innovation.landmark = *landmark;
    if (passesGate(innovation, state.covariance()))
      association.innovations.push_back(innovation);
    else
      ++association.gated;
  }
  counters.add("gated", static_cast<std::uint64_t>(association.gated));
  counters.add("unknown_id", static_cast<std::uint64_t>(association.unknown));
  return association;
}

bool KnownIdAssociation::passesGate(const Innovation& innovation, const DenseCovariance& P) const {
  const auto& H_r = innovation.H_robot;
  const auto& H_m = innovation.H_landmark;
  const Eigen::Matrix2d cross = H_m * P.landmarkRobot(innovation.landmark) * H_r.transpose();
  const Eigen::Matrix2d S = H_r * P.robot() * H_r.transpose() + cross + cross.transpose() +
                            H_m * P.landmark(innovation.landmark) * H_m.transpose() + innovation.R;
  return innovation.nu.dot(S.inverse() * innovation.nu) <= gate_;
}

}  // namespace slam::ekf
