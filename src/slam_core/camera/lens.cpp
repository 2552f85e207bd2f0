// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/lens.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace slam {
namespace {

constexpr double kWidestAngle = 1.5533;  // 89 deg from the axis: the plane z = 1 ends at 90

}  // namespace

Lens::Lens(const CameraCalibration& calibration)
    : is_equidistant_(calibration.distortion_model == "equidistant") {
  const auto& d = calibration.distortion;
  std::copy_n(d.begin(), std::min(d.size(), k_.size()), k_.begin());
  is_ideal_ =
      !is_equidistant_ && std::all_of(k_.begin(), k_.end(), [](double k) { return k == 0; });
  max_radius_ = is_ideal_ ? std::tan(kWidestAngle) : radiusOfFold();
}

std::optional<Eigen::Vector2d> Lens::distort(const Eigen::Vector2d& point,
                                             Eigen::Matrix2d* J) const {
  if (!(point.squaredNorm() <= max_radius_ * max_radius_)) return std::nullopt;
  return image(point, J);
}

std::optional<Eigen::Vector2d> Lens::undistort(const Eigen::Vector2d& distorted) const {
  if (is_ideal_) return distort(distorted);
  constexpr int kMaxIterations = 50;
  constexpr double kTolerance = 1e-13;
  Eigen::Vector2d point = distorted;
  if (is_equidistant_ && point.norm() < kWidestAngle && point.norm() > 0.0)
    point *= std::tan(point.norm()) / point.norm();  // exact without coefficients
  for (int i = 0; i < kMaxIterations; ++i) {
    const double radius = point.norm();
    if (radius > max_radius_) point *= max_radius_ / radius;
    Eigen::Matrix2d J;
    const Eigen::Vector2d error = distorted - image(point, &J);
    const Eigen::Vector2d step = J.inverse() * error;
    if (!step.allFinite()) return std::nullopt;
    point += step;
    if (step.squaredNorm() <= kTolerance * kTolerance * (1.0 + point.squaredNorm()))
      return distort(point) ? std::optional(point) : std::nullopt;
  }
  return std::nullopt;
}

Eigen::Vector2d Lens::image(const Eigen::Vector2d& point, Eigen::Matrix2d* J) const {
  if (is_equidistant_) return equidistant(point, J);
  if (!is_ideal_) return polynomial(point, J);
  if (J != nullptr) J->setIdentity();
  return point;
}

/// x'' = x' c + 2 p1 x'y' + p2 (r^2 + 2 x'^2), y'' = y' c + p1 (r^2 + 2 y'^2) + 2 p2 x'y',
/// c = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
Eigen::Vector2d Lens::polynomial(const Eigen::Vector2d& point, Eigen::Matrix2d* J) const {
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6] = k_;
  const double x = point.x(), y = point.y(), r2 = point.squaredNorm();
  const double numerator = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double denominator = 1.0 + r2 * (k4 + r2 * (k5 + r2 * k6));
  const double c = numerator / denominator;
  if (J != nullptr) {
    const double slope = (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3)) / denominator -
                         c * (k4 + r2 * (2.0 * k5 + r2 * 3.0 * k6)) / denominator;  // dc / dr^2
    const double cross = 2.0 * x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
    *J << c + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, cross,  //
        cross, c + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
  }
  return {x * c + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * c + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

/// theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8) along the direction of
/// the point; theta is the angle from the axis
Eigen::Vector2d Lens::equidistant(const Eigen::Vector2d& point, Eigen::Matrix2d* J) const {
  const double r = point.norm(), theta = std::atan(r), t2 = theta * theta;
  const double stretch = 1.0 + t2 * (k_[0] + t2 * (k_[1] + t2 * (k_[2] + t2 * k_[3])));
  const double scale = r > 1e-9 ? theta * stretch / r : 1.0;
  if (J != nullptr) {
    const double slope =  // d theta_d / d theta
        1.0 + t2 * (3.0 * k_[0] + t2 * (5.0 * k_[1] + t2 * (7.0 * k_[2] + t2 * 9.0 * k_[3])));
    J->setIdentity();
    *J *= scale;
    if (r > 1e-9) *J += (slope / (1.0 + r * r) - scale) / (r * r) * point * point.transpose();
  }
  return scale * point;
}

/// The smallest radius at which the image of some direction stops to move outward.
double Lens::radiusOfFold() const {
  constexpr int kSteps = 2000, kDirections = 8;
  double last = 0.0;
  for (int step = 1; step <= kSteps; ++step) {
    const double radius = std::tan(kWidestAngle * step / kSteps);
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * M_PI * i / kDirections;
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      Eigen::Matrix2d J;
      const auto at = image(radius * direction, &J);
      if (!at.allFinite() || direction.dot(J * direction) <= 0.0 || J.determinant() <= 0.0)
        return last;
    }
    last = radius;
  }
  return last;
}

}  // namespace slam
