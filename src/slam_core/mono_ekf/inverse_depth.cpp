// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/inverse_depth.hpp"

#include <cmath>
#include <limits>

namespace slam::mono_ekf {
namespace {

Eigen::Vector3d anchorOf(const InverseDepth& feature, double height) {
  return {feature(0), feature(1), height};
}

}  // namespace

Eigen::Vector3d directionOf(double azimuth, double elevation, Eigen::Matrix<double, 3, 2>* J) {
  const double ca = std::cos(azimuth), sa = std::sin(azimuth);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  if (J != nullptr) *J << -ce * sa, -se * ca, ce * ca, -se * sa, 0.0, ce;
  return {ce * ca, ce * sa, se};
}

Eigen::Vector3d pointOf(const InverseDepth& feature, double height,
                        Eigen::Matrix<double, 3, 5>* J) {
  Eigen::Matrix<double, 3, 2> J_ray;
  const Eigen::Vector3d ray = directionOf(feature(2), feature(3), &J_ray);
  const double depth = 1.0 / feature(4);
  if (J != nullptr) {
    J->setZero();
    J->topLeftCorner<2, 2>().setIdentity();
    J->middleCols<2>(2) = depth * J_ray;
    J->col(4) = -depth * depth * ray;
  }
  return anchorOf(feature, height) + depth * ray;
}

Eigen::Vector3d scaledVector(const InverseDepth& feature, double height,
                             const Eigen::Vector3d& centre_now, Eigen::Matrix<double, 3, 5>* J) {
  Eigen::Matrix<double, 3, 2> J_ray;
  const Eigen::Vector3d ray = directionOf(feature(2), feature(3), &J_ray);
  const Eigen::Vector3d way = anchorOf(feature, height) - centre_now;
  if (J != nullptr) {
    J->setZero();
    J->topLeftCorner<2, 2>() = feature(4) * Eigen::Matrix2d::Identity();
    J->middleCols<2>(2) = J_ray;
    J->col(4) = way;
  }
  return feature(4) * way + ray;
}

double linearityIndex(const InverseDepth& feature, double height, double sigma_rho,
                      const Eigen::Vector3d& centre_now) {
  const double rho = feature(4);
  if (!(rho > 0.0)) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d vector = pointOf(feature, height) - centre_now;
  const double distance = vector.norm(), sigma_depth = sigma_rho / (rho * rho);
  const double cos_parallax = directionOf(feature(2), feature(3)).dot(vector) / distance;
  return 4.0 * sigma_depth / distance * std::abs(cos_parallax);
}

}  // namespace slam::mono_ekf
