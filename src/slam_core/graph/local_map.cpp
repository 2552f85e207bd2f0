// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/local_map.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/graph/factors.hpp"

// Symbols: W a weight, e the errors and r = W e; J by corrections: twists of poses in their frames,
// and points in the map frame.

namespace slam::graph {
namespace {

constexpr Eigen::Index kPoseRows = 3, kPointRows = 2;

Eigen::Index pointRow(const LocalMap& map, std::size_t point) {
  return kPoseRows * static_cast<Eigen::Index>(map.poses.size()) +
         kPointRows * static_cast<Eigen::Index>(point);
}

/// Solves the normal equations of a tall matrix with three columns.
Eigen::Vector3d leastSquares(const Eigen::MatrixXd& J, const Eigen::VectorXd& r) {
  return J.colPivHouseholderQr().solve(r);
}

Eigen::Vector2d meanPosition(const std::vector<Pose2>& at) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& each : at) sum += each.position();
  return sum / static_cast<double>(at.size());
}

std::vector<Key> withoutBase(std::vector<Key> keys) {
  keys.insert(keys.begin(), -1);
  return keys;
}

}  // namespace

LocalMap marginal(const LocalMap& map, const std::vector<bool>& keeps) {
  LocalMap part{map.poses, {}, {}};
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < pointRow(map, 0); ++row) rows.push_back(row);
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    if (!keeps[i]) continue;
    part.points.push_back(map.points[i]);
    rows.push_back(pointRow(map, i));
    rows.push_back(pointRow(map, i) + 1);
  }
  part.covariance = map.covariance(rows, rows);
  return part;
}

BasedMap::BasedMap(std::vector<Key> keys, LocalMap map)
    : Factor(std::move(keys)), map_(std::move(map)), W_(weightOfCovariance(map_.covariance)) {}

/// The errors, and their Jacobian by the base alone.
BasedMap::Errors BasedMap::errors(const Pose2& base, const Pose2* at) const {
  Errors errors{Eigen::VectorXd(W_.cols()), Eigen::MatrixX3d(W_.cols(), kPoseRows)};
  for (std::size_t i = 0; i < map_.poses.size(); ++i) {
    const auto row = kPoseRows * static_cast<Eigen::Index>(i);
    const Pose2 known_inverse = map_.poses[i].inverse();
    const Pose2 in_base = base.between(at[i]);
    // a twist of the base moves the pose in it the other way, and turns it around the base
    Eigen::Matrix3d J_base = -known_inverse.twistJacobian();
    J_base.topRightCorner<2, 1>() =
        J_base.topLeftCorner<2, 2>() * Eigen::Vector2d(-in_base.y(), in_base.x());
    errors.e.segment<3>(row) = (known_inverse * in_base).vector();
    errors.J_base.middleRows<3>(row) = J_base;
  }
  const Pose2 map_in_base = base.inverse();
  for (std::size_t i = 0; i < map_.points.size(); ++i) {
    const auto row = pointRow(map_, i);
    const Eigen::Vector2d p = map_in_base.transform(at[map_.poses.size() + i].position());
    errors.e.segment<2>(row) = p - map_.points[i];
    errors.J_base.middleRows<2>(row) << -1.0, 0.0, p.y(), 0.0, -1.0, -p.x();
  }
  return errors;
}

LinearFactor BasedMap::linearized(const std::vector<Pose2>& at) const {
  const Pose2& base = at[0];
  const Errors errors = this->errors(base, at.data() + 1);
  const Eigen::Matrix2d R_base_map = base.rotation().transpose();
  LinearFactor linear{W_ * errors.e, Eigen::MatrixXd(W_.rows(), kPoseRows + W_.cols())};
  linear.J.leftCols<3>().noalias() = W_ * errors.J_base;
  for (std::size_t i = 0; i < map_.poses.size(); ++i) {
    const auto row = kPoseRows * static_cast<Eigen::Index>(i);
    const Pose2 error = map_.poses[i].inverse() * base.between(at[i + 1]);
    linear.J.middleCols<3>(kPoseRows + row).noalias() =
        W_.middleCols<3>(row) * error.twistJacobian();
  }
  for (std::size_t i = 0; i < map_.points.size(); ++i) {
    const auto row = pointRow(map_, i);
    linear.J.middleCols<2>(kPoseRows + row).noalias() = W_.middleCols<2>(row) * R_base_map;
  }
  return linear;
}

LinearFactor BasedMap::byBase(const Pose2& base, const std::vector<Pose2>& others) const {
  const Errors errors = this->errors(base, others.data());
  return {W_ * errors.e, W_ * errors.J_base};
}

FreeMap::FreeMap(std::vector<Key> keys, LocalMap map)
    : Factor(keys), based_(withoutBase(std::move(keys)), std::move(map)) {}

/// A pose shows where the base is. If there is none, the rigid motion of the points does (least
/// squares).
Pose2 FreeMap::firstBase(const std::vector<Pose2>& at) const {
  if (!map().poses.empty()) return at[0] * map().poses[0].inverse();
  const auto& points = map().points;
  const Eigen::Vector2d mean = meanPosition(at);
  Eigen::Vector2d mean_base = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean_base += point / static_cast<double>(points.size());
  double sine = 0.0, cosine = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d a = points[i] - mean_base, b = at[i].position() - mean;
    sine += a.x() * b.y() - a.y() * b.x();
    cosine += a.dot(b);
  }
  const Pose2 turn(0.0, 0.0, std::atan2(sine, cosine));
  const Eigen::Vector2d t = mean - turn.rotation() * mean_base;
  return {t.x(), t.y(), turn.theta()};
}

Pose2 FreeMap::base(const std::vector<Pose2>& at) const {
  constexpr int kMost = 10;
  constexpr double kConverged = 1e-9;
  Pose2 base = firstBase(at);
  for (int i = 0; i < kMost; ++i) {
    const auto linear = based_.byBase(base, at);
    const Eigen::Vector3d step = -leastSquares(linear.J, linear.r);
    base = base * Pose2::exp(step);
    if (step.norm() < kConverged) break;
  }
  return base;
}

LinearFactor FreeMap::linearized(const std::vector<Pose2>& at) const {
  std::vector<Pose2> with_base = at;
  with_base.insert(with_base.begin(), base(at));
  auto linear = based_.linearized(with_base);
  const Eigen::MatrixXd J_base = linear.J.leftCols<3>();
  const auto qr = J_base.colPivHouseholderQr();
  const auto rank = qr.rank();
  const Eigen::MatrixXd Q =
      qr.householderQ() * Eigen::MatrixXd::Identity(J_base.rows(), rank);  // what the base explains
  LinearFactor projected{linear.r, linear.J.rightCols(linear.J.cols() - 3)};
  projected.r -= Q * (Q.transpose() * projected.r).eval();
  projected.J -= Q * (Q.transpose() * projected.J).eval();
  return projected;
}

double FreeMap::moved(const std::vector<Pose2>& then, const std::vector<Pose2>& now) const {
  if (!map().poses.empty()) return Factor::moved(then, now);
  constexpr double kLeastRadius = 1.0, kLargestRadius = 30.0;  // [m]
  const Eigen::Vector2d middle_then = meanPosition(then), middle_now = meanPosition(now);
  double most = 0.0, radius = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Eigen::Vector2d before = then[i].position() - middle_then;
    radius = std::max(radius, before.norm());
    most = std::max(most, (now[i].position() - middle_now - before).norm());
  }
  return most / std::clamp(radius, kLeastRadius, kLargestRadius);
}

}  // namespace slam::graph
