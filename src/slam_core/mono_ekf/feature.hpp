// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "slam_core/camera/mat_archive.hpp"
#include "slam_core/camera/planar_camera.hpp"
#include "slam_core/common/time.hpp"

namespace slam::mono_ekf {

/// It keeps what the image in which a feature was seen first shows of it. The surface is taken to
/// face the camera: a small patch perpendicular to the ray.
struct FirstSight {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the camera, map frame [m]
  Eigen::Vector3d ray = Eigen::Vector3d::UnitX();    ///< map frame, of length 1
  /// Two directions along the surface, map frame, of length 1.
  Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();
  /// A step along them on a surface 1 m away moves the pixel by this [px/m].
  Eigen::Matrix2d J_pixel_tangents = Eigen::Matrix2d::Identity();
  cv::Mat patch;  ///< 8 bit gray, the feature in its centre

  template <class Archive>
  void persist(Archive& archive) {
    archive(centre, ray, tangents, J_pixel_tangents);
    persistMat(archive, patch);
  }
};

/// A point of the world that is recognised by what is around it in an image. Its coordinates are
/// part of the filter's state: an InverseDepth at first, (x, y, z) when its depth is known.
struct Feature {
  static constexpr int kCoordinates = 5, kPointCoordinates = 3;
  static constexpr int kOnTrial = 3, kSurest = 25;  ///< of `existence`

  std::uint64_t id = 0;
  bool is_point = false;
  int offset = 0;  ///< of its first coordinate in the state
  FirstSight first;
  Stamp begun;                ///< when it was seen first
  int matches = 0;            ///< images in which it was found where the others agree with it
  int existence = kOnTrial;   ///< grows when it is found, falls when not; 0: it is not there
  int images_unsearched = 0;  ///< since it was searched last, or began

  bool isProven() const { return matches >= kOnTrial; }
  int size() const { return is_point ? kPointCoordinates : kCoordinates; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(id, is_point, offset, first, begun, matches, existence, images_unsearched);
  }
};

/// The pixel at which a feature is predicted, with the Jacobians in the robot's pose and in the
/// feature's coordinates.
struct Prediction {
  using FeatureJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, Feature::kCoordinates>;

  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> J_pose;
  FeatureJacobian J_feature;
};

/// @param coordinates those of the feature
/// @return nothing where the camera cannot see it
std::optional<Prediction> predictedPixel(const PlanarCamera& camera, const Pose2& T_map_base,
                                         const Feature& feature,
                                         const Eigen::Ref<const Eigen::VectorXd>& coordinates);

/// The feature's point, map frame; nothing where it may be at infinity.
std::optional<Eigen::Vector3d> pointOf(const Feature& feature,
                                       const Eigen::Ref<const Eigen::VectorXd>& coordinates);

}  // namespace slam::mono_ekf
