// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/registration.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/scan_matching/surface.hpp"

// Symbols: e end of a beam in the robot's frame, p the same in the map [cells], r its offset from
// the surface, W information of r, w what the kernel leaves of it, J Jacobian of p by the pose, H
// and g the normal equations.

namespace slam::scan_matching {
namespace {

using grid_map::ScanPoints;

constexpr int kIterations = 15;
constexpr double kSmallStep = 1e-4;    // [m], [rad]
constexpr double kLeastWeight = 0.05;  // an end with less belongs to something else
constexpr double kDamping = 1e-6;

struct NormalEquations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  int ends = 0;
};

/// Of the offset of an end from a surface.
Eigen::Matrix2d informationOf(const Surface& surface, double variance) {
  const Eigen::Vector2d& n = surface.normal;
  const Eigen::Vector2d t(-n.y(), n.x());
  return n * n.transpose() / (variance + surface.across) +
         t * t.transpose() / (variance + surface.along);
}

class Fit {
 public:
  Fit(const grid_map::GridMap& map, const ScanPoints& scan, double sigma)
      : scan_(scan), finder_(map), variance_(std::pow(scan.cells_per_metre * sigma, 2)) {}

  NormalEquations at(const Pose2& pose) {
    NormalEquations sum;
    const double c = std::cos(pose.theta()), s = std::sin(pose.theta());
    const Eigen::Vector2d position = scan_.cells_per_metre * pose.position();
    for (const auto& end : scan_.ends) {
      const Eigen::Vector2d turned(c * end.x() - s * end.y(), s * end.x() + c * end.y());
      add(turned, turned + position, end, sum);
    }
    return sum;
  }

 private:
  void add(const Eigen::Vector2d& turned, const Eigen::Vector2d& p, const Eigen::Vector2d& end,
           NormalEquations& sum) {
    const auto* const surface = finder_.nearest(p);
    if (surface == nullptr) return;
    const double range_variance =
        scan_.relative_sigma * scan_.relative_sigma * (end - scan_.origin).squaredNorm();
    const Eigen::Matrix2d W = informationOf(*surface, variance_ + range_variance);
    const Eigen::Vector2d r = p - surface->point, Wr = W * r;
    const double root = 1.0 / (1.0 + r.dot(Wr)), w = root * root;
    if (!(w >= kLeastWeight)) return;
    Eigen::Matrix<double, 2, 3> J;
    J << scan_.cells_per_metre, 0.0, -turned.y(), 0.0, scan_.cells_per_metre, turned.x();
    sum.H += w * J.transpose() * W * J;
    sum.g += w * J.transpose() * Wr;
    ++sum.ends;
  }

  const ScanPoints& scan_;
  SurfaceFinder finder_;
  double variance_;
};

}  // namespace

Registration registerScan(const grid_map::GridMap& map, const ScanPoints& scan, const Pose2& start,
                          const PosePrior& prior, double sigma) {
  Registration found;
  found.pose = start;
  if (!scan.isOnMap(start)) return found;
  Fit fit(map, scan, sigma);
  for (int i = 0; i < kIterations && scan.isOnMap(found.pose); ++i) {
    const auto equations = fit.at(found.pose);
    found.information = equations.H;
    found.ends = equations.ends;
    if (!found.isDetermined()) break;
    Eigen::Vector3d error = found.pose.vector() - prior.pose.vector();
    error.z() = wrapAngle(error.z());
    const Eigen::Matrix3d H =
        equations.H + prior.information + kDamping * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = H.ldlt().solve(equations.g + prior.information * error);
    found.pose = Pose2::fromVector(found.pose.vector() - step);
    if (step.head<2>().norm() < kSmallStep && std::abs(step.z()) < kSmallStep) break;
  }
  return found;
}

}  // namespace slam::scan_matching
