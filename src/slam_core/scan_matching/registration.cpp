// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/scan_matching/surface.hpp"

// Symbols: p end of a beam in the map [cells], r its offset from the surface, n and t directions
// across and along that, W information of an offset, w what the kernel leaves of it, J Jacobian of
// an offset by the pose, H and g the normal equations, L and Q a root of H and axes in its
// coordinates.

namespace slam::scan_matching {
namespace {

using grid_map::ScanPoints;

constexpr int kIterations = 15;
constexpr double kSmallStep = 1e-4;    // [m], [rad]
constexpr double kLeastWeight = 0.05;  // an end with less belongs to something else
constexpr double kDamping = 1e-6;
constexpr double kDoubt = 2.0;  // safety factor on H_noise, which is estimated from few cells

/// The derivative of an end's coordinate along `direction` [cells] by the robot's (x, y, theta).
Eigen::Vector3d jacobian(const Eigen::Vector2d& direction, const Eigen::Vector2d& turned,
                         double cells_per_metre) {
  return {cells_per_metre * direction.x(), cells_per_metre * direction.y(),
          turned.x() * direction.y() - turned.y() * direction.x()};
}

struct NormalEquations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  Eigen::Matrix3d H_noise = Eigen::Matrix3d::Zero();  ///< of H, what noise of the normals makes
  int ends = 0;
  double weights = 0.0, squares = 0.0;  ///< of the ends, and of their offsets in sigmas

  /// The variance v of the ends' offsets, relative to that of the model, which is an upper bound.
  /// The kernel gives large offsets a small weight, so that the weighted mean square m of normal
  /// offsets is less than v. Integrated numerically for one offset of each end, m = v / (1 + 3 v)
  /// holds within 3 % up to v = 0.3; at v = 1 it is 0.25 instead of 0.31. This is inverted here.
  double shownVariance() const {
    constexpr double kHidden = 3.0, kLeast = 0.05;
    const double mean = squares / weights;
    return mean * (1.0 + kHidden) >= 1.0 ? 1.0 : std::max(kLeast, mean / (1.0 - kHidden * mean));
  }
  /// The offset `r` of an end along a direction, with the weight W.
  void add(double W, double r, const Eigen::Vector3d& J) {
    H += W * J * J.transpose();
    g += W * r * J;
  }
  /// Normals whose direction errs by the variance `tilt` [rad^2] add information along their
  /// surfaces, where there is none: W * tilt in the mean.
  void addNoise(double W, double tilt, const Eigen::Vector3d& J_along) {
    H_noise += W * tilt * J_along * J_along.transpose();
  }
  NormalEquations withoutNoise() const;
};

/// Whitens by H = L L^T. There the eigenvalues of H_noise are the shares of the information that
/// are noise, and each eigen-direction is scaled by what is left, 1 - kDoubt * share, or by 0 where
/// that is negative: along a corridor.
NormalEquations NormalEquations::withoutNoise() const {
  const Eigen::Matrix3d L =
      Eigen::LLT<Eigen::Matrix3d>(H + kDamping * Eigen::Matrix3d::Identity()).matrixL();
  const auto solve = [&L](const auto& right) {
    return L.triangularView<Eigen::Lower>().solve(right).eval();
  };
  const Eigen::Matrix3d half = solve(H_noise);
  const Eigen::Matrix3d noise = solve(half.transpose());
  const auto [variances, Q] = principalAxes(noise);
  const Eigen::Vector3d kept = (1.0 - kDoubt * variances.array()).max(0.0);
  const Eigen::Matrix3d LQ = L * Q;
  NormalEquations rest = *this;
  rest.g = LQ * kept.asDiagonal() * Q.transpose() * solve(g);
  rest.H = LQ * kept.asDiagonal() * LQ.transpose();
  return rest;
}

class Fit {
 public:
  Fit(const grid_map::GridMap& map, const ScanPoints& scan, double sigma)
      : scan_(scan), finder_(map), variance_(std::pow(scan.cells_per_metre * sigma, 2)) {}

  NormalEquations at(const Pose2& pose) {
    NormalEquations sum;
    const double c = std::cos(pose.theta()), s = std::sin(pose.theta());
    const Eigen::Vector2d position = scan_.cells_per_metre * pose.position();
    scan_.forEachFan([&](const auto& fan, const auto&, const auto& ends) {
      for (const auto& end : ends) {
        const Eigen::Vector2d turned(c * end.x() - s * end.y(), s * end.x() + c * end.y());
        const double range_variance =
            fan.relative_sigma * fan.relative_sigma * (end - fan.origin).squaredNorm();
        add(turned, turned + position, range_variance, sum);
      }
    });
    return sum;
  }

 private:
  void add(const Eigen::Vector2d& turned, const Eigen::Vector2d& p, double range_variance,
           NormalEquations& sum) {
    const auto* const surface = finder_.nearest(p);
    if (surface == nullptr) return;
    const double variance = variance_ + range_variance;
    const Eigen::Vector2d& n = surface->normal;
    const Eigen::Vector2d t(-n.y(), n.x()), r = p - surface->point;
    const double across = r.dot(n), along = r.dot(t);
    const double W_across = 1.0 / (variance + surface->across);
    const double W_along = surface->goesOn() ? 0.0 : 1.0 / (variance + surface->along);
    const double squared = W_across * across * across + W_along * along * along;
    const double root = 1.0 / (1.0 + squared), w = root * root;
    if (!(w >= kLeastWeight)) return;
    const auto J_along = jacobian(t, turned, scan_.cells_per_metre);
    sum.add(w * W_across, across, jacobian(n, turned, scan_.cells_per_metre));
    sum.addNoise(w * W_across, surface->tilt, J_along);
    if (W_along > 0.0) sum.add(w * W_along, along, J_along);
    ++sum.ends;
    sum.weights += w;
    sum.squares += w * squared;
  }

  const ScanPoints& scan_;
  SurfaceFinder finder_;
  double variance_;
};

/// The weight of a prior that the scan contradicts, as where wheels slip: the same kernel, but as
/// wide as kSigmas. A prior that is off by so many sigmas keeps a quarter of its weight.
double weightOfPrior(double squared_sigmas) {
  constexpr double kSigmas = 3.0;
  const double root = 1.0 / (1.0 + squared_sigmas / (kSigmas * kSigmas));
  return root * root;
}

}  // namespace

Registration registerScan(const grid_map::GridMap& map, const ScanPoints& scan, const Pose2& start,
                          const PosePrior& prior, double sigma) {
  Registration found;
  found.pose = start;
  if (!scan.isOnMap(start)) return found;
  Fit fit(map, scan, sigma);
  for (int i = 0; i < kIterations && scan.isOnMap(found.pose); ++i) {
    const auto all = fit.at(found.pose);
    const auto sure = all.withoutNoise();
    const auto& equations = prior.is_measured ? sure : all;
    found.ends = equations.ends;
    if (!found.isDetermined()) break;
    found.information = sure.H / sure.shownVariance();
    Eigen::Vector3d error = found.pose.vector() - prior.pose.vector();
    error.z() = wrapAngle(error.z());
    found.prior_weight = weightOfPrior(error.dot(prior.information * error));
    const Eigen::Matrix3d of_prior = found.prior_weight * prior.information;
    const Eigen::Matrix3d H = equations.H + of_prior + kDamping * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = H.ldlt().solve(equations.g + of_prior * error);
    found.pose = Pose2::fromVector(found.pose.vector() - step);
    if (step.head<2>().norm() < kSmallStep && std::abs(step.z()) < kSmallStep) break;
  }
  return found;
}

}  // namespace slam::scan_matching
