// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/association/local_landmark.hpp"
#include "slam_core/association/sensor_reach.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::association {

/// A place of the robot in a map, with the evidence for it.
struct Place {
  PoseEstimate robot;
  /// Logarithm of the likelihood ratio of the landmarks around the robot: at this place, over none
  /// of them belonging to the map.
  double log_odds = 0.0;
  std::size_t matches = 0;  ///< landmarks that are paired with one of the map
};

/// Weighs a place by the landmarks around the robot. Each of them may be none of the map; the
/// likelihood is integrated over all poses nearby (Laplace's approximation), so that places by few
/// precise and by many vague landmarks can be compared.
class ConstellationEvidence {
 public:
  /// @param map outlives this @param outlier_share probability that a landmark is none of the map,
  /// whatever its id says; in (0, 1)
  ConstellationEvidence(const LandmarkMap& map, double outlier_share);

  /// The best place near a pose. Landmarks of the map that lie within reach and are not seen count
  /// against it (negative evidence, Montemerlo 2003, ch. 3).
  /// @param around landmarks in the robot's frame @param reach of the robot's sensors, around its
  /// base
  /// @return nothing where fewer than two landmarks can be paired with the map
  std::optional<Place> near(Pose2 robot, const std::vector<LocalLandmark>& around,
                            const SensorReach& reach) const;
  /// The same logarithm of the best explanation that gives no place: that one of the landmarks is
  /// what its id says, while all others are not.
  double logOddsOfOneAlone(const std::vector<LocalLandmark>& around) const;
  /// Whether a landmark around the robot may be this one of the map, by ids and descriptors.
  static bool mayBe(const LocalLandmark& local, const Landmark& landmark) {
    constexpr double kRightPasses = 0.999;
    return mayHaveIdOf(local, landmark) &&
           fitOf(local.descriptor, landmark.descriptor, kRightPasses).passes;
  }
  /// Counts the landmarks of the map that a robot at this pose should see.
  std::size_t within(const SensorReach& reach, const Pose2& robot) const;
  /// Radius of the circle in which the robot must be to see landmarks of the map [m].
  double radius() const { return radius_; }

 private:
  struct Pairing {
    std::size_t local, landmark;
  };
  struct Normal {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
  };

  std::vector<Pairing> pairingsAt(const Pose2& robot,
                                  const std::vector<LocalLandmark>& around) const;
  Normal equationsAt(const Pose2& robot, const std::vector<LocalLandmark>& around,
                     const std::vector<Pairing>& pairings) const;
  double logOddsAt(const Pose2& robot, const std::vector<LocalLandmark>& around,
                   const std::vector<Pairing>& pairings) const;
  double logOddsOf(const Pose2& robot, const LocalLandmark& local, const Landmark* landmark) const;
  double logOddsOfMissing(const Pose2& robot, const std::vector<Pairing>& pairings,
                          const SensorReach& reach) const;
  static bool mayHaveIdOf(const LocalLandmark& local, const Landmark& landmark) {
    return local.id == kUnknownId || local.id == landmark.id;
  }
  bool isInMap(const LocalLandmark& local) const;

  const LandmarkMap& map_;
  double outlier_share_;
  double area_, radius_;
};

}  // namespace slam::association
