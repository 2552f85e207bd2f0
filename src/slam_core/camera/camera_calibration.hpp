// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace slam {

/// The intrinsics of a camera, as sensor_msgs/CameraInfo has them: for the raw, distorted image.
/// The centre of the upper left pixel is (0, 0).
struct CameraCalibration {
  int width = 0, height = 0;     ///< [px]
  std::string distortion_model;  ///< "plumb_bob", "rational_polynomial", "equidistant"
  double fx = 0.0, fy = 0.0;     ///< focal lengths [px]
  double cx = 0.0, cy = 0.0;     ///< principal point [px]
  std::vector<double> distortion;
  bool is_region = false;  ///< of a larger image, in which the principal point may be elsewhere

  bool operator==(const CameraCalibration& other) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(width, height, distortion_model, fx, fy, cx, cy, distortion, is_region);
  }
};

/// Empty, or what makes the calibration unusable (K all zero, NaN, a focal length or a principal
/// point of no camera, a distortion model that is not known, a wrong number of coefficients or ones
/// of no lens). No distortion: no coefficients, with or without a model.
std::string faultOf(const CameraCalibration& calibration);

/// Where a camera is mounted: its optical frame (x right, y down, z forward, REP-103) in the
/// robot's base frame.
struct CameraMount {
  std::string camera_frame;
  Eigen::Isometry3d T_base_camera = Eigen::Isometry3d::Identity();

  template <class Archive>
  void persist(Archive& archive) {
    archive(camera_frame, T_base_camera.matrix());
  }
};

/// Empty, or what makes the mount unusable (NaN, a matrix that does not rotate).
std::string faultOf(const CameraMount& mount);

}  // namespace slam
