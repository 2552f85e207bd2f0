// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/mono_graph/features.hpp"

namespace slam::mono_graph {

constexpr int kNoPoint = -1;
/// Keyframes that share so many points are neighbours.
constexpr int kNeighbourPoints = 15;

/// The covariance that a chain of keyframes from the first one gives a pose (x, y, theta) in the
/// map. It is a sum of two.
struct ChainCovariance {
  Eigen::Matrix3d by_points = Eigen::Matrix3d::Zero();    ///< of the links that points make
  Eigen::Matrix3d by_odometry = Eigen::Matrix3d::Zero();  ///< of those that odometry alone makes
  double odometry_way = 0.0;  ///< length of the latter; a turn by a radian counts as a metre [m]

  Eigen::Matrix3d sum() const { return by_points + by_odometry; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(by_points, by_odometry, odometry_way);
  }
};

/// A pose from which the map was seen, with what was seen.
struct Keyframe {
  Stamp stamp;
  Pose2 pose;  ///< T_map_base
  Features features;
  std::vector<int> points;  ///< of the map, by feature; kNoPoint where there is none
  /// Odometry led here from the keyframe before; nothing is known of it at the first one and behind
  /// a jump.
  std::optional<Pose2> way;
  Eigen::Matrix3d way_covariance = Eigen::Matrix3d::Zero();
  ChainCovariance covariance;  ///< by the best chain

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, pose, features, points, way, way_covariance, covariance);
  }
};

/// A keyframe saw a point.
struct Sighting {
  int keyframe = 0;
  int feature = 0;

  template <class Archive>
  void persist(Archive& archive) {
    archive(keyframe, feature);
  }
};

/// A point of the map.
struct MapPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the map frame [m]
  Descriptor descriptor{};
  double angle = 0.0;  ///< of its feature in the keyframe that made it [rad]
  double size = 0.0;   ///< [m] across, of what the descriptor compares
  /// The first is that of the keyframe that made it, as long as this one sees it; empty: it is
  /// gone.
  std::vector<Sighting> sightings;
  int expected = 0, found = 0;  ///< images in which it was to be seen, and was

  bool isGone() const { return sightings.empty(); }
  int host() const { return sightings.front().keyframe; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(position, descriptor, angle, size, sightings, expected, found);
  }
};

/// Keyframes, points, and which keyframe sees which point (Mur-Artal et al. 2015, III.C). The
/// points' positions are in the map frame; they follow the keyframe that made them where a loop
/// moves it.
class VisualMap {
 public:
  int add(Keyframe keyframe);
  /// @param point with one sighting at least, that of its host first
  int add(MapPoint point);
  /// Adds a sighting by a keyframe that does not see the point yet, with a feature that belongs to
  /// no point yet; not to a point that is gone, as its place may become that of another one.
  /// @return whether it was added
  bool addSighting(int point, Sighting sighting);
  void removeSighting(int point, int keyframe);
  void remove(int point);
  /// Two points are one: the first one gets the sightings of the second, which is gone.
  void merge(int point, int other);

  std::vector<Keyframe>& keyframes() { return keyframes_; }
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }
  std::vector<MapPoint>& points() { return points_; }  ///< those that are gone among them
  const std::vector<MapPoint>& points() const { return points_; }
  const Keyframe& keyframe(int i) const { return keyframes_[static_cast<std::size_t>(i)]; }
  Keyframe& keyframe(int i) { return keyframes_[static_cast<std::size_t>(i)]; }
  const MapPoint& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  MapPoint& point(int i) { return points_[static_cast<std::size_t>(i)]; }
  std::size_t countOfPoints() const { return points_.size() - free_.size(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(keyframes_, points_, free_);
  }

 private:
  std::vector<Keyframe> keyframes_;
  std::vector<MapPoint> points_;
  std::vector<int> free_;  ///< places of points that are gone
};

/// @return how many points each other keyframe sees of those that this one sees
std::map<int, int> sharedPoints(const VisualMap& map, int keyframe);
/// @return up to so many neighbours of a keyframe, those that share most points first
std::vector<int> neighboursOf(const VisualMap& map, int keyframe, std::size_t most);
/// The points that some keyframes see, each once, in rising order.
std::vector<int> pointsSeenBy(const VisualMap& map, const std::vector<int>& keyframes);
/// Moves keyframes to these poses, and each point with its host.
void moveKeyframes(VisualMap& map, const std::vector<Pose2>& poses);

}  // namespace slam::mono_graph
