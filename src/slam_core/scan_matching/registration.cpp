// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "slam_core/geometry/difference.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/scan_matching/rows.hpp"
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

/// An end of a beam on a surface: its offset from it across and along, the information that each of
/// these has, and their Jacobians. Lengths in cells.
struct EndOnSurface {
  Eigen::Vector2d surface;  ///< a point of it
  double across, along;
  double W_across, W_along;
  double tilt;  ///< variance of the direction across [rad^2]
  Eigen::Vector3d J_across, J_along;

  double squared() const { return W_across * across * across + W_along * along * along; }
  double weight() const {
    const double root = 1.0 / (1.0 + squared());
    return root * root;
  }
  Eigen::Matrix3d information() const {
    return W_across * J_across * J_across.transpose() + W_along * J_along * J_along.transpose();
  }
};

class Fit {
 public:
  Fit(const grid_map::GridMap& map, const ScanPoints& scan, double sigma)
      : scan_(scan),
        rows_(rowsOf(scan)),
        finder_(map),
        variance_(std::pow(scan.cells_per_metre * sigma, 2)) {}

  /// Calls visit(end, weight) for each end that lies on a surface.
  template <class Visit>
  void forEachEnd(const Pose2& pose, const Visit& visit) {
    const double c = std::cos(pose.theta()), s = std::sin(pose.theta());
    const Eigen::Vector2d position = scan_.cells_per_metre * pose.position();
    scan_.forEachFan([&](const auto& fan, const auto&, const auto& ends) {
      for (const auto& end : ends) {
        const Eigen::Vector2d turned(c * end.x() - s * end.y(), s * end.x() + c * end.y());
        const auto* const surface = finder_.nearest(turned + position);
        if (surface == nullptr) continue;
        const double range_variance =
            fan.relative_sigma * fan.relative_sigma * (end - fan.origin).squaredNorm();
        const auto& row = rows_[static_cast<std::size_t>(&end - scan_.ends.data())];
        const auto seen = row.length > 0.0 ? alongRow(*surface, row, c, s) : *surface;
        const auto fitted = onSurface(seen, turned, turned + position, range_variance);
        const double w = fitted.weight();
        if (w >= kLeastWeight) visit(fitted, w);
      }
    });
  }

  NormalEquations at(const Pose2& pose) {
    NormalEquations sum;
    forEachEnd(pose, [&sum](const EndOnSurface& end, double w) {
      sum.add(w * end.W_across, end.across, end.J_across);
      sum.addNoise(w * end.W_across, end.tilt, end.J_along);
      if (end.W_along > 0.0) sum.add(w * end.W_along, end.along, end.J_along);
      ++sum.ends;
      sum.weights += w;
      sum.squares += w * end.squared();
    });
    return sum;
  }

 private:
  /// The map shows no more than a place here. The row shows the direction of its surface.
  Surface alongRow(const Surface& surface, const Row& row, double c, double s) const {
    if (!surface.is_isolated) return surface;
    const auto& d = row.direction;
    Surface seen = surface;
    seen.normal = {-s * d.x() - c * d.y(), c * d.x() - s * d.y()};
    seen.across = surface.along;
    seen.along = std::numeric_limits<double>::infinity();
    seen.tilt = 2.0 * variance_ / (row.length * row.length);
    return seen;
  }

  EndOnSurface onSurface(const Surface& surface, const Eigen::Vector2d& turned,
                         const Eigen::Vector2d& p, double range_variance) const {
    const double variance = variance_ + range_variance;
    const Eigen::Vector2d& n = surface.normal;
    const Eigen::Vector2d t(-n.y(), n.x()), r = p - surface.point;
    return {surface.point,
            r.dot(n),
            r.dot(t),
            1.0 / (variance + surface.across),
            surface.goesOn() ? 0.0 : 1.0 / (variance + surface.along),
            surface.tilt,
            jacobian(n, turned, scan_.cells_per_metre),
            jacobian(t, turned, scan_.cells_per_metre)};
  }

  const ScanPoints& scan_;
  std::vector<Row> rows_;
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

/// The covariance of the prior gets as much along the error e as makes e^T information e smaller by
/// the weight.
Eigen::Matrix3d informationLeft(const PosePrior& prior, const Pose2& found, double weight) {
  const Eigen::Vector3d e = difference(found, prior.pose);
  const Eigen::Vector3d pull = prior.information * e;
  const double squared = e.dot(pull);
  if (!(squared > 0.0)) return prior.information;
  return prior.information - (1.0 - weight) / squared * pull * pull.transpose();
}

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
    const Eigen::Vector3d error = difference(found.pose, prior.pose);
    found.prior_weight = weightOfPrior(error.dot(prior.information * error));
    const Eigen::Matrix3d of_prior = informationLeft(prior, found.pose, found.prior_weight);
    const Eigen::Matrix3d H = equations.H + of_prior + kDamping * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = H.ldlt().solve(equations.g + of_prior * error);
    found.pose = Pose2::fromVector(found.pose.vector() - step);
    if (step.head<2>().norm() < kSmallStep && std::abs(step.z()) < kSmallStep) break;
  }
  return found;
}

std::vector<FittedEnd> fittedEnds(const grid_map::GridMap& map, const ScanPoints& scan,
                                  const Pose2& pose, double sigma) {
  std::vector<FittedEnd> fitted;
  if (!scan.isOnMap(pose)) return fitted;
  fitted.reserve(scan.ends.size());
  Fit(map, scan, sigma).forEachEnd(pose, [&](const EndOnSurface& end, double w) {
    fitted.push_back({end.surface / scan.cells_per_metre, w * end.information()});
  });
  return fitted;
}

}  // namespace slam::scan_matching
