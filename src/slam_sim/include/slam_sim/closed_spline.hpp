// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace slam::sim {

/// A closed curve through points: a periodic cubic spline over the chord length, twice continuously
/// differentiable, addressed by the way s [m] along it. Any s is allowed, also beyond the length.
class ClosedSpline {
 public:
  /// @param points at least three, successive ones not the same [m]
  explicit ClosedSpline(const std::vector<Eigen::Vector2d>& points);

  double length() const { return length_; }  ///< of one round [m]
  Eigen::Vector2d point(double s) const;
  double heading(double s) const;    ///< of the tangent [rad]
  double curvature(double s) const;  ///< positive to the left [1/m]

 private:
  struct Derivatives {
    Eigen::Vector2d value, first, second;  ///< in the parameter u
  };

  Derivatives at(double u) const;
  double speed(double u) const { return at(u).first.norm(); }
  double parameter(double s) const;
  void solveSecondDerivatives();
  void tabulate();

  std::vector<Eigen::Vector2d> points_;   ///< the first one again at the end
  std::vector<double> knots_;             ///< u at each of points_
  std::vector<Eigen::Vector2d> seconds_;  ///< second derivatives there
  std::vector<double> parameters_;        ///< u at multiples of step_
  double step_ = 0.0, length_ = 0.0;
};

}  // namespace slam::sim
