// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/knowledge_bound.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/principal_axes.hpp"

namespace slam::particle_filter {
namespace {

template <class Matrix>
Matrix symmetric(const Matrix& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

/// Where f, which has one maximum, is largest in (0, 1): golden section search.
template <class Function>
double argmax(const Function& f) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSteps = 10;
  double low = 0.0, high = 1.0;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double f_a = f(a), f_b = f(b);
  for (int i = 0; i < kSteps; ++i) {
    if (f_a > f_b) {
      high = b;
      b = a;
      f_b = f_a;
      f_a = f(a = high - kGolden * (high - low));
    } else {
      low = a;
      a = b;
      f_a = f_b;
      f_b = f(b = low + kGolden * (high - low));
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

template <int N>
Eigen::Matrix<double, N, N> intersected(const Eigen::Matrix<double, N, N>& own,
                                        const Eigen::Matrix<double, 2, N>& H,
                                        const Eigen::Matrix2d& other,
                                        const Eigen::Matrix2d& independent) {
  using Square = Eigen::Matrix<double, N, N>;
  const Square own_information = own.inverse();
  const auto information = [&](double weight) -> Square {
    const Eigen::Matrix2d noise = other / (1.0 - weight) + independent;
    return weight * own_information + H.transpose() * noise.inverse() * H;
  };
  const double weight = argmax([&](double w) { return information(w).determinant(); });
  const Square fused = information(weight);
  const bool is_gain = fused.determinant() > own_information.determinant();
  const Square covariance = symmetric<Square>(fused.inverse());
  return is_gain && covariance.allFinite() ? covariance : own;
}

template <int N>
Eigen::Matrix<double, N, N> atLeast(const Eigen::Matrix<double, N, N>& bound,
                                    const Eigen::Matrix<double, N, N>& covariance) {
  using Square = Eigen::Matrix<double, N, N>;
  const Eigen::LLT<Square> L(covariance);
  if (L.info() != Eigen::Success) return bound;
  Square whitened = L.matrixL().solve(bound);  // then L^-1 bound L^-T
  whitened = L.matrixL().solve(whitened.transpose().eval());
  const auto [variances, directions] = principalAxes(symmetric(whitened));
  if (!variances.allFinite()) return covariance;
  const Square back = L.matrixL() * directions;
  const Square result = back * variances.cwiseMax(1.0).asDiagonal() * back.transpose();
  return symmetric(result);
}

template Eigen::Matrix2d intersected<2>(const Eigen::Matrix2d&, const Eigen::Matrix2d&,
                                        const Eigen::Matrix2d&, const Eigen::Matrix2d&);
template Eigen::Matrix3d intersected<3>(const Eigen::Matrix3d&, const Eigen::Matrix<double, 2, 3>&,
                                        const Eigen::Matrix2d&, const Eigen::Matrix2d&);
template Eigen::Matrix2d atLeast<2>(const Eigen::Matrix2d&, const Eigen::Matrix2d&);
template Eigen::Matrix3d atLeast<3>(const Eigen::Matrix3d&, const Eigen::Matrix3d&);

void KnowledgeBound::restart(const Eigen::Matrix3d& pose) {
  landmarks_.clear();
  pose_ = pose;
  pose_since_ = genealogy_.now();
}

void KnowledgeBound::setPose(const Eigen::Matrix3d& covariance) {
  pose_ = covariance;
  pose_since_ = Genealogy::kNever;
}

void KnowledgeBound::load(const LandmarkMap& map, double inflation) {
  landmarks_.clear();
  pose_since_ = Genealogy::kNever;
  for (const auto& landmark : map)
    landmarks_.push_back({inflation * inflation * landmark.covariance, Genealogy::kNever});
}

Eigen::Matrix3d KnowledgeBound::told(const Eigen::Matrix3d& covariance) const {
  const double share = genealogy_.forgottenSince(pose_since_);
  return (1.0 - share) * covariance + share * atLeast<3>(pose_, covariance);
}

Eigen::Matrix2d KnowledgeBound::told(const Eigen::Matrix2d& covariance, std::size_t number) const {
  const auto& landmark = landmarks_[number];
  const double share = genealogy_.forgottenSince(landmark.since);
  return (1.0 - share) * covariance + share * atLeast<2>(landmark.covariance, covariance);
}

void KnowledgeBound::move(const Pose2& from, const Motion& motion) {
  Eigen::Matrix3d J_from, J_u;
  from.compose(motion.increment, &J_from, &J_u);
  pose_ = symmetric<Eigen::Matrix3d>(J_from * pose_ * J_from.transpose() +
                                     J_u * motion.covariance * J_u.transpose());
}

void KnowledgeBound::observe(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                             const Eigen::Vector2d& landmark, std::size_t number,
                             const LandmarkObservation& z, bool map_is_fixed) {
  Eigen::Matrix<double, 2, 3> H_robot;
  Eigen::Matrix2d H_landmark;
  const auto z_predicted = model.predict(robot, sensor, landmark, &H_robot, &H_landmark);
  if (model.isSingular(z_predicted)) return;
  auto& m = landmarks_[number].covariance;
  const Eigen::Matrix2d of_pose = H_robot * pose_ * H_robot.transpose();
  const Eigen::Matrix2d of_landmark = H_landmark * m * H_landmark.transpose();
  pose_ = intersected<3>(pose_, H_robot, of_landmark, z.covariance);
  if (!map_is_fixed) m = intersected<2>(m, H_landmark, of_pose, z.covariance);
}

void KnowledgeBound::begin(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                           std::size_t number, const LandmarkObservation& z) {
  Eigen::Matrix<double, 2, 3> J_robot;
  Eigen::Matrix2d J_z;
  model.invert(robot, sensor, z.vector(), &J_robot, &J_z);
  const Eigen::Matrix2d covariance =
      J_robot * pose_ * J_robot.transpose() + J_z * z.covariance * J_z.transpose();
  if (number == landmarks_.size()) landmarks_.emplace_back();
  // what the pose's error has in common with it was forgotten as far as the pose's own
  landmarks_[number] = {symmetric(covariance), pose_since_};
}

}  // namespace slam::particle_filter
