// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "slam_core/graph/calibrated_factors.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/local_map.hpp"

namespace slam::graph {

/// The numbers of the kinds in an archive.
enum class FactorKind : std::uint8_t {
  kPosePrior,
  kPointPrior,
  kJointPrior,
  kBetween,
  kSighting,
  kParameterPrior,
  kCalibratedBetween,
  kCalibratedSighting,
  kBasedMap,
  kFreeMap
};

/// @return whether the factor depends on parameters or is a prior on them; otherwise nothing is
/// written
template <class Archive>
bool writeCalibrated(const Factor& factor, Archive& archive) {
  if (const auto* prior = dynamic_cast<const ParameterPrior*>(&factor)) {
    archive(FactorKind::kParameterPrior, prior->known(), prior->weight());
  } else if (const auto* between = dynamic_cast<const CalibratedBetween*>(&factor)) {
    archive(FactorKind::kCalibratedBetween, between->motion(), between->weight());
  } else if (const auto* sighting = dynamic_cast<const CalibratedSighting*>(&factor)) {
    const auto& seen = sighting->seen();
    archive(FactorKind::kCalibratedSighting, seen.sensor(), seen.measured(), seen.weight(),
            sighting->then());
  } else {
    return false;
  }
  return true;
}

/// Writes a factor with its kind. @throw std::logic_error if its kind is not listed here
template <class Archive>
void write(const Factor& factor, Archive& archive) {
  archive(factor.keys());
  if (const auto* pose = dynamic_cast<const PosePrior*>(&factor))
    archive(FactorKind::kPosePrior, pose->known(), pose->weight());
  else if (const auto* point = dynamic_cast<const PointPrior*>(&factor))
    archive(FactorKind::kPointPrior, point->known(), point->weight());
  else if (const auto* joint = dynamic_cast<const JointPrior*>(&factor))
    archive(FactorKind::kJointPrior, joint->pose(), joint->points(), joint->weight());
  else if (const auto* between = dynamic_cast<const Between*>(&factor))
    archive(FactorKind::kBetween, between->measured(), between->weight());
  else if (const auto* sighting = dynamic_cast<const RangeBearing*>(&factor))
    archive(FactorKind::kSighting, sighting->sensor(), sighting->measured(), sighting->weight());
  else if (const auto* based = dynamic_cast<const BasedMap*>(&factor))
    archive(FactorKind::kBasedMap, based->map());
  else if (const auto* free = dynamic_cast<const FreeMap*>(&factor))
    archive(FactorKind::kFreeMap, free->map());
  else if (!writeCalibrated(factor, archive))
    throw std::logic_error("this kind of factor cannot be written");
}

/// @return null if it is of another kind
template <class Archive>
std::shared_ptr<const Factor> readCalibrated(Archive& archive, FactorKind kind,
                                             const std::vector<Key>& keys) {
  const std::size_t size = keys.size();
  if (kind == FactorKind::kParameterPrior) {
    Eigen::VectorXd known;
    Eigen::MatrixXd W;
    archive(known, W);
    return std::make_shared<ParameterPrior>(keys, known, W);
  }
  if (kind == FactorKind::kCalibratedBetween && size == 4) {
    WheelMotion motion;
    Eigen::Matrix3d W;
    archive(motion, W);
    return std::make_shared<CalibratedBetween>(keys[0], keys[1], parametersOf(keys), motion, W);
  }
  if (kind == FactorKind::kCalibratedSighting && (size == 4 || size == 5)) {
    Pose2 sensor;
    Eigen::Vector2d z;
    Eigen::Matrix2d W;
    CalibratedSighting::At then;
    archive(sensor, z, W, then);
    return std::make_shared<CalibratedSighting>(keys[0], keys[1], parametersOf(keys),
                                                RangeBearing(keys[0], keys[1], sensor, z, W), then);
  }
  return nullptr;
}

/// @return null if it is of another kind
template <class Archive>
std::shared_ptr<const Factor> readLocalMap(Archive& archive, FactorKind kind,
                                           const std::vector<Key>& keys) {
  if (kind != FactorKind::kBasedMap && kind != FactorKind::kFreeMap) return nullptr;
  LocalMap map;
  archive(map);
  const auto variables = map.poses.size() + map.points.size();
  const auto rows = static_cast<Eigen::Index>(3 * map.poses.size() + 2 * map.points.size());
  const bool is_square = map.covariance.rows() == rows && map.covariance.cols() == rows;
  if (is_square && kind == FactorKind::kBasedMap && keys.size() == variables + 1)
    return std::make_shared<BasedMap>(keys, std::move(map));
  if (is_square && kind == FactorKind::kFreeMap && keys.size() == variables)
    return std::make_shared<FreeMap>(keys, std::move(map));
  return nullptr;
}

/// @throw std::runtime_error if the archive holds no factor
template <class Archive>
std::shared_ptr<const Factor> readFactor(Archive& archive) {
  std::vector<Key> keys;
  FactorKind kind{};
  Pose2 pose;
  Eigen::Vector2d point;
  std::vector<Eigen::Vector2d> points;
  Eigen::Matrix2d W2;
  Eigen::Matrix3d W3;
  Eigen::MatrixXd W;
  archive(keys, kind);
  const std::size_t size = keys.size();
  if (kind == FactorKind::kPosePrior && size == 1)
    return archive(pose, W3), std::make_shared<PosePrior>(keys[0], pose, W3);
  if (kind == FactorKind::kPointPrior && size == 1)
    return archive(point, W2), std::make_shared<PointPrior>(keys[0], point, W2);
  if (kind == FactorKind::kJointPrior)
    return archive(pose, points, W), std::make_shared<JointPrior>(keys, pose, points, W);
  if (kind == FactorKind::kBetween && size == 2)
    return archive(pose, W3), std::make_shared<Between>(keys[0], keys[1], pose, W3);
  if (kind == FactorKind::kSighting && size == 2)
    return archive(pose, point, W2),
           std::make_shared<RangeBearing>(keys[0], keys[1], pose, point, W2);
  if (auto calibrated = readCalibrated(archive, kind, keys)) return calibrated;
  if (auto map = readLocalMap(archive, kind, keys)) return map;
  throw std::runtime_error("it holds a factor of unknown kind: save it again");
}

/// Writes or reads a factor. A factor that several objects share is written once.
template <class Archive>
void persistFactor(Archive& archive, std::shared_ptr<const Factor>& factor) {
  if constexpr (Archive::kReads)
    archive.shared(factor, [&] { return readFactor(archive); });
  else
    archive.shared(factor, [&] { write(*factor, archive); });
}

}  // namespace slam::graph
