// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/sighting_fusion.hpp"

#include <Eigen/LU>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::landmark_graph {

std::optional<LandmarkObservation> fused(const LandmarkObservation& a, const Pose2& sensor_a,
                                         const LandmarkObservation& b, const Pose2& sensor_b) {
  const RangeBearingModel model;
  Eigen::Matrix2d J_place_a, J_b_place;
  const auto place = model.invert(Pose2(), sensor_a, a.vector(), nullptr, &J_place_a);
  const auto predicted = model.predict(Pose2(), sensor_b, place, nullptr, &J_b_place);
  if (model.isSingular(predicted)) return std::nullopt;
  const Eigen::Matrix2d J = J_b_place * J_place_a;
  const Eigen::Matrix2d P = J * a.covariance * J.transpose();
  const Eigen::Matrix2d K = P * (P + b.covariance).inverse();
  const Eigen::Vector2d z = predicted + K * model.innovation(b.vector(), predicted);
  // in Joseph's form, which stays positive where P - K P is nothing but rounding
  const Eigen::Matrix2d left = Eigen::Matrix2d::Identity() - K;
  const Eigen::Matrix2d covariance = left * P * left.transpose() + K * b.covariance * K.transpose();
  LandmarkObservation both = b;
  both.range = z.x();
  both.bearing = wrapAngle(z.y());
  both.covariance = 0.5 * (covariance + covariance.transpose());
  return both;
}

}  // namespace slam::landmark_graph
