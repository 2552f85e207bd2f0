// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/grid_map/scan_points.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/scan_matching/match.hpp"
#include "slam_core/scan_matching/registration.hpp"

namespace slam::scan_matching {

/// The uncertainty of the surfaces of a map that is built scan by scan without closing loops. A
/// surface has the error that the robot's pose had when it was drawn first. A robot that is matched
/// with surfaces has their error, so that its covariance depends on which surfaces it sees, and not
/// on where it is: it comes back to where it began, and is as sure as it was there once it is
/// matched with what it drew there. Beyond, the covariance grows with each metre. The errors of
/// successive metres are taken to be independent, so that their variances add (a random walk).
class MapDrift {
 public:
  /// @param position, heading standard deviation after a metre [m, rad]
  MapDrift(double position, double heading)
      : variance_per_metre_(position * position, position * position, heading * heading) {}

  /// The map starts, empty, at this pose.
  void restart(const PoseEstimate& first);
  /// A map was loaded, with the robot at this pose. It is the reference: its surfaces do not err,
  /// until the robot draws at the same places.
  void restartInLoadedMap(const Pose2& robot);
  /// The robot is elsewhere. Its whole covariance is that relative to the surfaces.
  void relocate(const Pose2& pose);
  /// The robot was matched with the map, or not: then the match has no information.
  /// @param robot its pose, and its covariance relative to the surfaces; if it was found among the
  /// older ones, this is the whole covariance that it has before the match
  /// @param ends the ends that the match has used
  void follow(const PoseEstimate& robot, const Match& found, const std::vector<FittedEnd>& ends);
  /// The robot draws from a pose that has this covariance relative to the surfaces so far, so that
  /// it misplaces the next ones by as much.
  void anchor(const Eigen::Matrix3d& covariance);
  /// A scan was drawn at this pose, where the robot is.
  void add(const grid_map::ScanPoints& scan, const Pose2& pose);

  /// The covariance, in (x, y, theta), of a robot at this pose that knows exactly where it is
  /// relative to the surfaces that it was matched with last.
  Eigen::Matrix3d covarianceAt(const Pose2& pose) const;
  /// Whether the robot's pose relative to the surfaces is less certain than these surfaces, and so
  /// uncertain that what it draws may be misplaced.
  bool isSurerThan(const PoseEstimate& robot) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(places_, drawn_from_, has_loaded_map_, robot_);
  }

 private:
  using PlaceIndex = std::uint32_t;  ///< in places_

  /// The covariance at `pose` of a robot whose error at `place` was that of the place.
  Eigen::Matrix3d carried(const PoseEstimate& place, const Pose2& pose) const;
  /// Null if it was not drawn by add().
  const PoseEstimate* placeOf(const Eigen::Vector2d& surface) const;

  Eigen::Vector3d variance_per_metre_;
  std::vector<PoseEstimate> places_;                          ///< from which surfaces were drawn
  std::unordered_map<std::uint64_t, PlaceIndex> drawn_from_;  ///< of each square of the plane
  bool has_loaded_map_ = false;
  PoseEstimate robot_;  ///< the error that it has of the surfaces that it was matched with
};

}  // namespace slam::scan_matching
