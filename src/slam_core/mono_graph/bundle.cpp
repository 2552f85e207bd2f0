// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/bundle.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/chi_square.hpp"

namespace slam::mono_graph {
namespace {

constexpr double kUnseen = 1e4;   // chi2 of what a view does not see
constexpr double kEnough = 1e-5;  // relative decrease of the loss at which the steps end
constexpr double kDamping = 1e-4, kLessDamping = 0.2, kMoreDamping = 8.0, kMostDamping = 1e4;

/// Huber's loss, linear beyond the gate.
double lossOf(double chi2) {
  return chi2 <= kGateOfTwo ? chi2 : 2.0 * std::sqrt(kGateOfTwo * chi2) - kGateOfTwo;
}

std::size_t indexOf(int i) { return static_cast<std::size_t>(i); }

/// @return what odometry measured against what two views say, with the Jacobians
Eigen::Vector3d errorOf(const Bundle& bundle, const Bundle::Way& way, Eigen::Matrix3d* J_from,
                        Eigen::Matrix3d* J_to) {
  Eigen::Matrix3d J_inverse, J_first, J_second;
  const Pose2 inverse = bundle.views[indexOf(way.from)].pose.inverse(&J_inverse);
  const Pose2 step = inverse.compose(bundle.views[indexOf(way.to)].pose, &J_first, &J_second);
  if (J_from != nullptr) *J_from = J_first * J_inverse;
  if (J_to != nullptr) *J_to = J_second;
  Eigen::Vector3d error = step.vector() - way.increment.vector();
  error.z() = wrapAngle(error.z());
  return error;
}

double lossOf(const Bundle& bundle) {
  double loss = 0.0;
  for (const auto& observation : bundle.observations) loss += lossOf(chi2Of(bundle, observation));
  for (const auto& way : bundle.ways) {
    const Eigen::Vector3d error = errorOf(bundle, way, nullptr, nullptr);
    loss += error.dot(way.covariance.llt().solve(error));
  }
  return loss;
}

/// The normal equations of a bundle: those of the poses dense, those of the points one by one.
class Equations {
 public:
  explicit Equations(const Bundle& bundle) : column_(bundle.views.size(), -1) {
    int columns = 0;
    for (std::size_t i = 0; i < bundle.views.size(); ++i)
      if (!bundle.views[i].is_fixed) column_[i] = 3 * columns++;
    H_.setZero(3 * columns, 3 * columns);
    g_.setZero(3 * columns);
    points_.resize(bundle.points.size());
    for (const auto& observation : bundle.observations) add(bundle, observation);
    for (const auto& way : bundle.ways) add(bundle, way);
  }

  /// The bundle after one step. @return whether the step is a number
  bool step(double damping, Bundle& bundle) const {
    Eigen::MatrixXd S = H_;  // of which the lower triangle is used
    S.diagonal() *= 1.0 + damping;
    Eigen::VectorXd reduced = g_;
    std::vector<Eigen::Matrix3d> inverses(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      inverses[i] = damped(points_[i].H, damping).inverse();
      eliminate(points_[i], inverses[i], S, reduced);
    }
    const Eigen::VectorXd delta = S.ldlt().solve(reduced);
    if (!delta.allFinite()) return false;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Eigen::Vector3d rhs = points_[i].g;
      for (const auto& [column, W] : points_[i].with_poses)
        rhs -= W.transpose() * delta.segment<3>(column);
      bundle.points[i] -= inverses[i] * rhs;
    }
    for (std::size_t i = 0; i < column_.size(); ++i)
      if (column_[i] >= 0)
        bundle.views[i].pose =
            Pose2::fromVector(bundle.views[i].pose.vector() - delta.segment<3>(column_[i]));
    return true;
  }

 private:
  struct Point {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    std::vector<std::pair<int, Eigen::Matrix3d>> with_poses;  ///< by the pose's column
  };

  /// A point that nothing determines stays where it is.
  static Eigen::Matrix3d damped(const Eigen::Matrix3d& H, double damping) {
    constexpr double kLeast = 1e-9;
    Eigen::Matrix3d result = H;
    result.diagonal() *= 1.0 + damping;
    result.diagonal().array() += kLeast;
    return result;
  }

  static void eliminate(const Point& point, const Eigen::Matrix3d& inverse, Eigen::MatrixXd& S,
                        Eigen::VectorXd& reduced) {
    for (const auto& [row, W] : point.with_poses) {
      const Eigen::Matrix3d left = W * inverse;
      reduced.segment<3>(row) -= left * point.g;
      for (const auto& [column, V] : point.with_poses)
        if (column <= row) S.block<3, 3>(row, column).noalias() -= left * V.transpose();
    }
  }

  void add(const Bundle& bundle, const Bundle::Observation& observation) {
    Eigen::Matrix<double, 2, 3> J_pose, J_point;
    const auto& view = bundle.views[indexOf(observation.view)];
    const auto seen = view.camera.project(view.pose, bundle.points[indexOf(observation.point)],
                                          &J_pose, &J_point);
    if (!seen) return;
    const Eigen::Vector2d r = *seen - observation.seen;
    double weight = 1.0 / (observation.sigma * observation.sigma);
    const double chi2 = weight * r.squaredNorm();
    if (chi2 > kGateOfTwo) weight *= std::sqrt(kGateOfTwo / chi2);
    auto& point = points_[indexOf(observation.point)];
    point.H += weight * J_point.transpose() * J_point;
    point.g += weight * J_point.transpose() * r;
    const int column = column_[indexOf(observation.view)];
    if (column < 0) return;
    H_.block<3, 3>(column, column) += weight * J_pose.transpose() * J_pose;
    g_.segment<3>(column) += weight * J_pose.transpose() * r;
    point.with_poses.emplace_back(column, weight * J_pose.transpose() * J_point);
  }

  void add(const Bundle& bundle, const Bundle::Way& way) {
    std::array<Eigen::Matrix3d, 2> J;
    const Eigen::Vector3d error = errorOf(bundle, way, &J[0], &J[1]);
    const Eigen::Matrix3d information = way.covariance.inverse();
    const std::array<int, 2> columns = {column_[indexOf(way.from)], column_[indexOf(way.to)]};
    for (std::size_t a = 0; a < 2; ++a) {
      if (columns[a] < 0) continue;
      g_.segment<3>(columns[a]) += J[a].transpose() * information * error;
      for (std::size_t b = 0; b < 2; ++b)
        if (columns[b] >= 0)
          H_.block<3, 3>(columns[a], columns[b]) += J[a].transpose() * information * J[b];
    }
  }

  std::vector<int> column_;  ///< of each view; -1 where it is fixed
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
  std::vector<Point> points_;
};

}  // namespace

double chi2Of(const Bundle& bundle, const Bundle::Observation& observation) {
  const auto& view = bundle.views[indexOf(observation.view)];
  const auto seen = view.camera.project(view.pose, bundle.points[indexOf(observation.point)]);
  if (!seen) return kUnseen;
  return (*seen - observation.seen).squaredNorm() / (observation.sigma * observation.sigma);
}

void adjust(Bundle& bundle, int most_steps) {
  double damping = kDamping, loss = lossOf(bundle);
  std::optional<Equations> equations;
  for (int i = 0; i < most_steps && damping < kMostDamping; ++i) {
    if (!equations) equations.emplace(bundle);
    Bundle next = bundle;
    const double next_loss = equations->step(damping, next) ? lossOf(next) : loss;
    if (!(next_loss < loss)) {
      damping *= kMoreDamping;
      continue;
    }
    const bool is_enough = loss - next_loss <= kEnough * loss;
    bundle = std::move(next);
    loss = next_loss;
    damping *= kLessDamping;
    equations.reset();
    if (is_enough) break;
  }
}

}  // namespace slam::mono_graph
