// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/place_fault.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace slam {
namespace {

constexpr const char* kFar = " is more than 100000 km from the map's origin";

/// Whether a matrix is finite, symmetric and positive semidefinite, up to rounding. It is looked at
/// in units of its standard deviations; what is known exactly has none.
bool isSpread(const Eigen::MatrixXd& P) {
  constexpr double kRounding = 1e-6;
  if (!P.allFinite() || (P.diagonal().array() < 0.0).any()) return false;
  const Eigen::VectorXd sigma = P.diagonal().cwiseSqrt();
  const Eigen::VectorXd weight =
      sigma.unaryExpr([](double each) { return each > 0.0 ? 1.0 / each : 0.0; });
  Eigen::MatrixXd correlations = weight.asDiagonal() * P * weight.asDiagonal();
  if (!(correlations - correlations.transpose()).isZero(kRounding)) return false;
  for (Eigen::Index i = 0; i < P.rows(); ++i) {
    if (sigma(i) == 0.0 && (P.row(i).array() != 0.0).any()) return false;
    correlations(i, i) = 1.0 + kRounding;
  }
  return Eigen::LLT<Eigen::MatrixXd>(correlations).info() == Eigen::Success;
}

bool isFar(const Eigen::Vector2d& position) {
  return position.lpNorm<Eigen::Infinity>() > kFarthestInMap;
}

std::string faultOfLandmark(const Landmark& landmark) {
  const auto& extent = landmark.extent;
  if (!landmark.position.allFinite() || !std::isfinite(landmark.direction) ||
      !std::isfinite(extent.begin) || !std::isfinite(extent.end))
    return " holds a value that is not a number";
  if (isFar(landmark.position)) return kFar;
  if (!isSpread(landmark.covariance)) return "'s covariance is not positive definite";
  if (landmark.covariance.diagonal().maxCoeff() > kFarthestInMap * kFarthestInMap)
    return "'s position is not known to 100000 km";
  return faultOf(landmark.descriptor);
}

std::string faultOfLandmarks(const LandmarkMap& landmarks) {
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (i > 0 && landmarks[i - 1].id >= landmarks[i].id)
      return fmt::format("landmark {} is there twice, or out of order", landmarks[i].id);
    if (const auto fault = faultOfLandmark(landmarks[i]); !fault.empty())
      return fmt::format("landmark {}{}", landmarks[i].id, fault);
  }
  return "";
}

std::string faultOfGrid(const OccupancyGrid& grid) {
  if (std::uint64_t{grid.width} * grid.height != grid.cells.size())
    return "the grid has not as many cells as its width times its height";
  if (grid.cells.empty()) return "";
  if (!(grid.resolution > 0.0) || !std::isfinite(grid.resolution))
    return "the grid's resolution is no length";
  if (!grid.origin.allFinite() || isFar(grid.origin))
    return std::string("the grid's origin") + kFar;
  return "";
}

}  // namespace

std::string faultOf(const PoseEstimate& estimate) {
  if (!estimate.pose.isFinite()) return "the pose holds a value that is not a number";
  if (isFar(estimate.pose.position())) return std::string("the pose") + kFar;
  if (!isSpread(estimate.covariance)) return "the pose's covariance is not positive definite";
  return "";
}

std::string faultOf(const MapState& map) {
  if (const auto fault = faultOf(map.robot); !fault.empty()) return fault;
  if (const auto fault = faultOfLandmarks(map.landmarks); !fault.empty()) return fault;
  const auto size = 3 + 2 * static_cast<Eigen::Index>(map.landmarks.size());
  const auto& joint = map.joint_covariance;
  if (joint.size() > 0 && (joint.rows() != size || joint.cols() != size))
    return "the joint covariance is not as large as the map";
  if (!isSpread(joint)) return "the joint covariance is not positive definite";
  return map.grid ? faultOfGrid(*map.grid) : "";
}

}  // namespace slam
