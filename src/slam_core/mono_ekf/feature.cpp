// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/feature.hpp"

#include "slam_core/mono_ekf/inverse_depth.hpp"

namespace slam::mono_ekf {

std::optional<Prediction> predictedPixel(const PlanarCamera& camera, const Pose2& T_map_base,
                                         const Feature& feature,
                                         const Eigen::Ref<const Eigen::VectorXd>& coordinates) {
  Eigen::Matrix3d J_centre_pose;
  const auto centre = camera.centre(T_map_base, &J_centre_pose);
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, Feature::kCoordinates> J_vector_feature;
  Eigen::Vector3d vector;
  double scale = 1.0;
  if (feature.is_point) {
    vector = coordinates.head<3>() - centre;
    J_vector_feature = Eigen::Matrix3d::Identity();
  } else {
    Eigen::Matrix<double, 3, 5> J;
    vector = scaledVector(coordinates.head<5>(), feature.first.centre.z(), centre, &J);
    J_vector_feature = J;
    scale = coordinates(4);
  }
  const auto projection = camera.project(T_map_base, vector);
  if (!projection) return std::nullopt;
  Prediction prediction;
  prediction.pixel = projection->pixel;
  prediction.J_pose = -scale * projection->J_vector * J_centre_pose;
  prediction.J_pose.col(2) += projection->J_theta;
  prediction.J_feature = projection->J_vector * J_vector_feature;
  return prediction;
}

std::optional<Eigen::Vector3d> pointOf(const Feature& feature,
                                       const Eigen::Ref<const Eigen::VectorXd>& coordinates) {
  constexpr double kInfinity = 1e-3;  // [1/m]
  if (feature.is_point) return coordinates.head<3>();
  if (coordinates(4) < kInfinity) return std::nullopt;
  return pointOf(InverseDepth(coordinates.head<5>()), feature.first.centre.z());
}

}  // namespace slam::mono_ekf
