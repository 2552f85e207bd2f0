// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "slam_core/camera/camera_calibration.hpp"

namespace slam {

/// The distortion of a lens: of points on the plane z = 1 before the camera. Two kinds behind one
/// interface: Brown's polynomial (Brown 1971) with its rational extension (plumb_bob is the one
/// with a denominator of 1; the formulas of OpenCV's calib3d) and the equidistant fish-eye (Kannala
/// and Brandt 2006).
///
/// The polynomials are fitted within the image and fold back far outside: beyond the angle where
/// the image radius stops to grow a point has no image.
class Lens {
 public:
  Lens() = default;
  /// @pre faultOf(calibration) is empty
  explicit Lens(const CameraCalibration& calibration);

  /// Where the lens puts a point, with the 2x2 Jacobian; nothing outside its field of view.
  std::optional<Eigen::Vector2d> distort(const Eigen::Vector2d& point,
                                         Eigen::Matrix2d* J = nullptr) const;
  /// The inverse, by Newton's method.
  std::optional<Eigen::Vector2d> undistort(const Eigen::Vector2d& distorted) const;

 private:
  Eigen::Vector2d polynomial(const Eigen::Vector2d& point, Eigen::Matrix2d* J) const;
  Eigen::Vector2d equidistant(const Eigen::Vector2d& point, Eigen::Matrix2d* J) const;
  Eigen::Vector2d image(const Eigen::Vector2d& point, Eigen::Matrix2d* J) const;
  double radiusOfFold() const;

  bool is_equidistant_ = false;
  bool is_ideal_ = true;
  std::array<double, 8> k_{};  ///< k1 k2 p1 p2 k3 k4 k5 k6, or k1 k2 k3 k4 of the fish-eye
  double max_radius_ = 0.0;    ///< of points that have an image
};

}  // namespace slam
