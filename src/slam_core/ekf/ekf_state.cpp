// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_state.hpp"

#include <algorithm>
#include <numeric>

namespace slam::ekf {
namespace {

DenseCovariance covarianceOf(const MapState& map, double inflation) {
  if (map.joint_covariance.size() > 0) return DenseCovariance(map.joint_covariance);
  const auto size = 3 + 2 * static_cast<Eigen::Index>(map.landmarks.size());
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(size, size);
  P.topLeftCorner<3, 3>() = map.robot.covariance;
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    const auto row = 3 + 2 * static_cast<Eigen::Index>(i);
    P.block<2, 2>(row, row) = inflation * inflation * map.landmarks[i].covariance;
  }
  return DenseCovariance(P);
}

}  // namespace

EkfState::EkfState(const PoseEstimate& robot) : robot_(robot.pose), P_(robot.covariance) {}

EkfState::EkfState(const MapState& map, double inflation)
    : robot_(map.robot.pose), P_(covarianceOf(map, inflation)) {
  for (const auto& landmark : map.landmarks) {
    index_[landmark.id] = static_cast<Eigen::Index>(ids_.size());
    ids_.push_back(landmark.id);
    landmarks_.push_back(landmark.position);
  }
}

std::optional<Eigen::Index> EkfState::find(LandmarkId id) const {
  const auto found = index_.find(id);
  if (found == index_.end()) return std::nullopt;
  return found->second;
}

void EkfState::add(const Eigen::VectorXd& dx) {
  robot_ = Pose2::fromVector(robot_.vector() + dx.head<3>());
  for (Eigen::Index row = 3; row < dx.size(); row += 2)
    landmarks_[static_cast<std::size_t>((row - 3) / 2)] += dx.segment<2>(row);
}

void EkfState::append(LandmarkId id, const Eigen::Vector2d& m_map,
                      const Eigen::Matrix<double, 2, 3>& J_m_robot, const Eigen::Matrix2d& R) {
  P_.append(J_m_robot, R);
  index_[id] = static_cast<Eigen::Index>(ids_.size());
  ids_.push_back(id);
  landmarks_.push_back(m_map);
}

std::vector<Eigen::Index> EkfState::orderById() const {
  std::vector<Eigen::Index> order(ids_.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [this](Eigen::Index a, Eigen::Index b) {
    return ids_[static_cast<std::size_t>(a)] < ids_[static_cast<std::size_t>(b)];
  });
  return order;
}

LandmarkMap EkfState::map() const {
  LandmarkMap map;
  map.reserve(ids_.size());
  for (const auto i : orderById())
    map.push_back({ids_[static_cast<std::size_t>(i)], landmark(i), P_.landmark(i)});
  return map;
}

MapState EkfState::state() const {
  const auto joint = P_.joint();
  Eigen::VectorXi rows(joint.rows());
  rows.head<3>() << 0, 1, 2;
  int row = 3;
  for (const auto i : orderById())
    for (int axis = 0; axis < 2; ++axis) rows(row++) = static_cast<int>(3 + 2 * i) + axis;
  return {pose(), map(), joint(rows, rows)};
}

}  // namespace slam::ekf
