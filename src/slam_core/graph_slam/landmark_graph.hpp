// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "slam_core/graph_slam/landmark_ids.hpp"
#include "slam_core/graph_slam/path_graph.hpp"
#include "slam_core/graph_slam/sighting_index.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::graph_slam {

/// An observation of a landmark of the graph.
struct Match {
  std::size_t landmark = 0;
  LandmarkObservation z;
};

/// The landmarks of a graph: a factor of range and bearing for each one that is seen from a node of
/// the path. What is seen before the next node is due goes into the last one's factors, so that a
/// robot that stands still does not make the graph grow. A node is due when the robot has moved, or
/// where its motion is less certain than what it sees.
class LandmarkGraph {
 public:
  /// @param path outlives this
  explicit LandmarkGraph(PathGraph& path) : path_(path) {}

  /// A map that was saved, before anything else is in the graph. Without a joint covariance, or
  /// with a very large one, landmarks get their marginals times `inflation` squared.
  void load(const MapState& map, double inflation);

  PoseEstimate robot() const { return path_.robot(); }
  const LandmarkIds& ids() const { return ids_; }
  /// To retire one: the graph keeps what was seen of it.
  friend LandmarkIds& idsOf(LandmarkGraph& landmarks) { return landmarks.ids_; }
  friend SightingIndex& sightingsOf(LandmarkGraph& landmarks) { return landmarks.index_; }
  Eigen::Vector2d point(std::size_t landmark) const {
    return path_.graph().pose(keys_[landmark]).position();
  }
  /// The covariance of the robot, as a twist in its frame, and of some landmarks, one after
  /// another.
  Eigen::MatrixXd covariance(const std::vector<std::size_t>& landmarks) const;
  Eigen::Matrix2d covariance(std::size_t landmark) const {
    return path_.graph().covariance({keys_[landmark]});
  }

  void observe(const std::vector<Match>& matches, const Pose2& sensor);
  /// A landmark at a place [m] where an observation puts it; where its id is unknown or another
  /// one's, it gets one that is free.
  void append(LandmarkId id, const Eigen::Vector2d& place, const LandmarkObservation& z,
              const Pose2& sensor);
  /// Removes all factors of a landmark and re-initialises it at this place.
  void reinitialize(std::size_t landmark, const Eigen::Vector2d& place,
                    const LandmarkObservation& z, const Pose2& sensor);
  LandmarkMap map() const;  ///< sorted by id, with marginals
  MapState state() const;   ///< sorted by id, with the joint covariance

 private:
  friend struct SessionParts;  // writes and reads its members

  /// What the last node knows of a landmark.
  struct Sighting {
    LandmarkObservation z;
    Pose2 sensor;  ///< T_node_sensor
  };

  void addLandmark(LandmarkId id, const Eigen::Vector2d& place);
  LandmarkObservation carriedBack(const LandmarkObservation& z, const Pose2& sensor) const;
  bool isBlurred(const LandmarkObservation& z, const Pose2& sensor) const;
  void see(std::size_t landmark, const LandmarkObservation& z, const Pose2& sensor);

  PathGraph& path_;
  LandmarkIds ids_;
  std::vector<graph::Key> keys_;  ///< by number
  SightingIndex index_;

  graph::Key sightings_node_ = -1;
  std::unordered_map<std::size_t, Sighting> sightings_;  ///< of this node, by landmark
};

}  // namespace slam::graph_slam
