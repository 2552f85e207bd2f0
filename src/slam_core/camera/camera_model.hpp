// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/lens.hpp"

namespace slam {

/// A calibrated camera: points before it to pixels and back. Points are in the optical frame
/// (x right, y down, z forward) [m], pixels in the raw image, whose upper left pixel has its centre
/// at (0, 0).
class CameraModel {
 public:
  CameraModel() = default;
  /// @pre faultOf(calibration) is empty
  explicit CameraModel(const CameraCalibration& calibration)
      : calibration_(calibration), lens_(calibration) {}

  const CameraCalibration& calibration() const { return calibration_; }

  /// The pixel of a point, which may lie outside the image, with the 2x3 Jacobian [px/m]; nothing
  /// where the point is behind the camera or outside the lens's field of view.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point,
                                         Eigen::Matrix<double, 2, 3>* J = nullptr) const;
  /// The point (x/z, y/z) on the plane z = 1 that a pixel sees; nothing where it sees none.
  std::optional<Eigen::Vector2d> unproject(const Eigen::Vector2d& pixel) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(calibration_);
    if constexpr (Archive::kReads) lens_ = Lens(calibration_);
  }

 private:
  CameraCalibration calibration_;
  Lens lens_;
};

}  // namespace slam
