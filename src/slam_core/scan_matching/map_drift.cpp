// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/map_drift.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/geometry/principal_axes.hpp"

// Symbols: S covariance of a robot's pose by the error of surfaces, I information of its pose by
// their ends, w the share of that in all information along each axis.

namespace slam::scan_matching {
namespace {

constexpr double kEdge = 0.1;  // of a square [m]

std::uint64_t squareOf(const Eigen::Vector2d& point) {
  const auto index = [](double length) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(length / kEdge)));
  };
  return std::uint64_t{index(point.x())} << 32 | index(point.y());
}

double positionVariance(const Eigen::Matrix3d& covariance) {
  return covariance.topLeftCorner<2, 2>().trace();
}

/// M such that M whole M^T = part. What the ends say without the noise that they share is spread
/// over them as what they say with it.
Eigen::Matrix3d scaleOf(const Eigen::Matrix3d& whole, const Eigen::Matrix3d& part) {
  constexpr double kDamping = 1e-6;
  const Eigen::LLT<Eigen::Matrix3d> root(whole + kDamping * Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d L = root.matrixL();
  const Eigen::Matrix3d L_inverse =
      L.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d::Identity());
  const auto [values, V] = principalAxes(symmetric(L_inverse * part * L_inverse.transpose()));
  const Eigen::Matrix3d sqrt = V * values.cwiseMax(0.0).cwiseSqrt().asDiagonal() * V.transpose();
  return L * sqrt * L_inverse;
}

/// Surfaces with the same error.
struct Surfaces {
  Eigen::Matrix3d S, I;
};

/// The heading, and the directions in which the position is known best and worst.
Eigen::Matrix3d axesOf(const Eigen::Matrix3d& information) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.topLeftCorner<2, 2>() =
      principalAxes(Eigen::Matrix2d(information.topLeftCorner<2, 2>())).directions;
  return axes;
}

/// The covariance of a robot that is matched with all of them. Each S includes all that errs
/// between these surfaces and the robot, and their errors are about the same. So along each axis
/// the variance is the mean, each surface counting by its information there. A correlation is the
/// mean over those that count along both axes; where these are few, the errors along both axes are
/// not those of the same surfaces, and independent.
Eigen::Matrix3d meanOf(const std::vector<Surfaces>& all) {
  Eigen::Matrix3d whole = Eigen::Matrix3d::Zero();
  for (const auto& surfaces : all) whole += surfaces.I;
  const Eigen::Matrix3d A = axesOf(whole);
  constexpr double kTiny = 1e-9;
  const Eigen::Vector3d most = (A.transpose() * whole * A).diagonal().cwiseMax(kTiny);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero(), weights = sum;
  for (const auto& [S, I] : all) {
    const Eigen::Vector3d w = (A.transpose() * I * A).diagonal().cwiseQuotient(most).cwiseMax(0.0);
    const Eigen::Matrix3d both = (w * w.transpose()).cwiseSqrt();
    sum += both.cwiseProduct(A.transpose() * S * A);
    weights += both;
  }
  constexpr double kFew = 0.5;
  const Eigen::Matrix3d P = sum.cwiseQuotient(weights.cwiseMax(kFew));
  const auto [values, V] = principalAxes(symmetric(A * P * A.transpose()));
  return V * values.cwiseMax(0.0).asDiagonal() * V.transpose();
}

}  // namespace

void MapDrift::restart(const PoseEstimate& first) {
  robot_ = first;
  places_.clear();
  drawn_from_.clear();
  has_loaded_map_ = false;
}

void MapDrift::restartInLoadedMap(const Pose2& robot) {
  restart({robot, Eigen::Matrix3d::Zero()});
  has_loaded_map_ = true;
}

void MapDrift::relocate(const Pose2& pose) { robot_ = {pose, Eigen::Matrix3d::Zero()}; }

Eigen::Matrix3d MapDrift::carried(const PoseEstimate& place, const Pose2& pose) const {
  const Pose2 way = place.pose.between(pose);
  Eigen::Matrix3d J_place;
  place.pose.compose(way, &J_place);
  Eigen::Matrix3d P = J_place * place.covariance * J_place.transpose();
  P.diagonal() += way.position().norm() * variance_per_metre_;
  return P;
}

const PoseEstimate* MapDrift::placeOf(const Eigen::Vector2d& surface) const {
  const auto found = drawn_from_.find(squareOf(surface));
  return found == drawn_from_.end() ? nullptr : &places_[found->second];
}

void MapDrift::follow(const PoseEstimate& robot, const Match& found,
                      const std::vector<FittedEnd>& ends) {
  if (found.is_among_older) relocate(robot.pose);
  const Eigen::Matrix3d& information = found.information;
  const Eigen::Matrix3d before = carried(robot_, robot.pose);
  robot_ = {robot.pose, before};
  const Eigen::LLT<Eigen::Matrix3d> root(robot.covariance);
  if (information.isZero() || root.info() != Eigen::Success) return;
  std::map<const PoseEstimate*, Eigen::Matrix3d> seen;  // in the order of places_
  Eigen::Matrix3d whole = Eigen::Matrix3d::Zero();
  for (const auto& end : ends) {
    seen.try_emplace(placeOf(end.surface), Eigen::Matrix3d::Zero()).first->second +=
        end.information;
    whole += end.information;
  }
  const Eigen::Matrix3d scale = scaleOf(whole, information);
  // what the robot knew before has the error that it had
  std::vector<Surfaces> all = {{before, root.solve(Eigen::Matrix3d::Identity()) - information}};
  for (const auto& [place, of_ends] : seen) {
    const Eigen::Matrix3d I = scale * of_ends * scale.transpose();
    if (place != nullptr)
      all.push_back({carried(*place, robot.pose), I});
    else if (has_loaded_map_)
      all.push_back({Eigen::Matrix3d::Zero(), I});
    else  // it moved in the map: its error is taken to be the robot's
      all.front().I += I;
  }
  robot_.covariance = meanOf(all);
}

void MapDrift::anchor(const Eigen::Matrix3d& covariance) { robot_.covariance += covariance; }

void MapDrift::add(const grid_map::ScanPoints& scan, const Pose2& pose) {
  const auto place = static_cast<PlaceIndex>(places_.size());
  bool is_new = false;
  for (const auto& beam : scan.beams) {
    if (!beam.isHit()) continue;
    const Eigen::Vector2d end = pose.transform(beam.end / scan.cells_per_metre);
    is_new = drawn_from_.try_emplace(squareOf(end), place).second || is_new;
  }
  if (is_new) places_.push_back({pose, covarianceAt(pose)});
}

Eigen::Matrix3d MapDrift::covarianceAt(const Pose2& pose) const { return carried(robot_, pose); }

bool MapDrift::isSurerThan(const PoseEstimate& robot) const {
  constexpr double kVague = 0.2;  // [m]
  const double variance = positionVariance(robot.covariance);
  return variance > kVague * kVague && variance > positionVariance(covarianceAt(robot.pose));
}

}  // namespace slam::scan_matching
