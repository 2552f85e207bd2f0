// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/landmark_graph/landmark_ids.hpp"
#include "slam_core/landmark_graph/path_graph.hpp"
#include "slam_core/landmark_graph/sighting_index.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::graph_slam {
struct SessionParts;
}

namespace slam::landmark_graph {

/// An observation of a landmark of the graph.
struct Match {
  std::size_t landmark = 0;
  LandmarkObservation z;
};

/// From where something is seen: a node of the path, or the robot where it is now.
using Viewpoint = std::optional<graph::Key>;

/// Observations of one stamp as if they had been made from a node of the path.
struct NodeObservations {
  graph::Key node = -1;
  LandmarkObservationArray array;           ///< its sensor pose is T_node_sensor
  graph::CalibratedSighting::At then = {};  ///< the parameters by which the array was corrected

  template <class Archive>
  void persist(Archive& archive) {
    archive(node, array, then);
  }
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

  PoseEstimate robot(const Viewpoint& from = {}) const { return path_.robot(from); }
  /// Whether parameters of the sensor are estimated: then observations are given as they are with
  /// the parameters now.
  friend bool calibrates(const LandmarkGraph& landmarks) {
    return parametersOf(landmarks.path_) != nullptr;
  }
  /// The sensor's pose in the map. @param on_robot its pose on the robot, or T_node_sensor
  friend PoseEstimate sensorOf(const LandmarkGraph& landmarks, const Pose2& on_robot,
                               const Viewpoint& from);
  /// The variance of the logarithm of the ranges' scale.
  friend double rangeScaleVarianceOf(const LandmarkGraph& landmarks);
  const LandmarkIds& ids() const { return ids_; }
  /// To retire one: the graph keeps what was seen of it.
  friend LandmarkIds& idsOf(LandmarkGraph& landmarks) { return landmarks.ids_; }
  friend SightingIndex& sightingsOf(LandmarkGraph& landmarks) { return landmarks.index_; }
  /// The variable of a landmark in the graph.
  friend graph::Key keyOf(const LandmarkGraph& landmarks, std::size_t landmark) {
    return landmarks.keys_[landmark];
  }
  /// The newest node of the path; none before the first one.
  friend std::optional<graph::Key> lastNodeOf(const LandmarkGraph& landmarks) {
    return landmarks.path_.tail().node;
  }
  Eigen::Vector2d point(std::size_t landmark) const {
    return path_.graph().pose(keys_[landmark]).position();
  }
  /// The covariance of the robot, as a twist in its frame, and of some landmarks, one after
  /// another.
  Eigen::MatrixXd covariance(const std::vector<std::size_t>& landmarks,
                             const Viewpoint& from = {}) const;
  /// The same with the sensor's pose, as a twist in its frame, in the place of the robot's: with
  /// what is in doubt of the sensor's place, and of the scale of its ranges as if the landmarks
  /// were nearer. Only where parameters are estimated.
  /// @param sensor on the robot, or T_node_sensor
  friend Eigen::MatrixXd covarianceFrom(const LandmarkGraph& graph, const Pose2& sensor,
                                        const std::vector<std::size_t>& landmarks,
                                        const Viewpoint& from);
  Eigen::Matrix2d covariance(std::size_t landmark) const {
    return path_.graph().covariance({keys_[landmark]});
  }

  void observe(const std::vector<Match>& matches, const Pose2& sensor);
  /// To be called when the graph holds no observation of the last node any more.
  friend void startSightings(LandmarkGraph& landmarks) { landmarks.startNode(-1); }
  /// Observations that are to be decided on later, as if made from the last node.
  friend NodeObservations fromNode(LandmarkGraph& landmarks, const LandmarkObservationArray& array);
  /// An observation of an earlier node, which may have seen the landmark before.
  /// @param sensor T_node_sensor
  void observe(const Match& match, const Pose2& sensor, graph::Key node);
  /// Observations of a node as they are with the parameters now.
  friend NodeObservations renewed(const LandmarkGraph& landmarks, NodeObservations seen);
  /// A landmark at a place [m] where an observation puts it; where its id is unknown or another
  /// one's, it gets one that is free.
  void append(LandmarkId id, const Eigen::Vector2d& place, const LandmarkObservation& z,
              const Pose2& sensor);
  /// Removes all factors of a landmark and re-initialises it at this place.
  void reinitialize(std::size_t landmark, const Eigen::Vector2d& place,
                    const LandmarkObservation& z, const Pose2& sensor);
  /// The landmarks that were seen from a node where all else in the graph does not have them now.
  /// @param gate largest squared residual, by its covariance
  friend std::vector<std::size_t> contradictionsOf(const LandmarkGraph& landmarks, graph::Key node,
                                                   double gate);
  /// Removes what a node saw of a landmark. @return what it saw
  friend NodeObservations withdraw(LandmarkGraph& landmarks, std::size_t landmark, graph::Key node);
  LandmarkMap map() const;  ///< sorted by id, with marginals
  MapState state() const;   ///< sorted by id, with the joint covariance

  template <class Archive>
  void persist(Archive& archive) {
    archive(ids_, keys_, index_, sightings_node_, sightings_);
  }

 private:
  friend struct graph_slam::SessionParts;  // writes and reads its members

  /// What the last node knows of a landmark.
  struct Sighting {
    LandmarkObservation z;
    Pose2 sensor;                             ///< T_node_sensor
    graph::CalibratedSighting::At then = {};  ///< the parameters by which both were corrected

    template <class Archive>
    void persist(Archive& archive) {
      archive(z, sensor, then);
    }
  };

  void addLandmark(LandmarkId id, const Eigen::Vector2d& place);
  LandmarkObservation carriedBack(const LandmarkObservation& z, const Pose2& sensor) const;
  bool isBlurred(const LandmarkObservation& z, const Pose2& sensor) const;
  void see(std::size_t landmark, const LandmarkObservation& z, const Pose2& sensor);
  void addSighting(std::size_t landmark, const Sighting& sighting, graph::Key node);
  /// The sighting as it is with the parameters now.
  Sighting renewed(Sighting sighting) const;
  Sighting sightingOf(std::size_t landmark, graph::Key node) const;
  void startNode(graph::Key node);

  PathGraph& path_;
  LandmarkIds ids_;
  std::vector<graph::Key> keys_;  ///< by number
  SightingIndex index_;

  graph::Key sightings_node_ = -1;
  std::unordered_map<std::size_t, Sighting> sightings_;  ///< of this node, by landmark
};

}  // namespace slam::landmark_graph
