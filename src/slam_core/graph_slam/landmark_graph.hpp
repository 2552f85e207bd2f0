// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/contract/stamped_pose.hpp"
#include "slam_core/graph/optimizer.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::graph_slam {

/// When the graph gets a new pose: the robot has moved so far since the last one.
struct NodeLimits {
  double distance = 0.05;  ///< [m]
  double angle = 0.05;     ///< [rad]
};

/// An observation of a landmark of the graph.
struct Match {
  std::size_t landmark = 0;
  LandmarkObservation z;
};

/// The robot's path and the landmarks as a graph: a node for each pose from which something new was
/// seen, a factor of motion between one and the next, and one of range and bearing for each
/// landmark seen from a node. The robot is where the last node and the motion since then put it.
/// What is seen before the next node is due goes into the last one's factors, so that a robot that
/// stands still does not make the graph grow.
class LandmarkGraph {
 public:
  LandmarkGraph() : LandmarkGraph({}, PoseEstimate{}) {}
  LandmarkGraph(const NodeLimits& limits, const PoseEstimate& start);
  /// A map that was saved. Without a joint covariance, or with a very large one, landmarks get
  /// their marginals times `inflation` squared.
  LandmarkGraph(const NodeLimits& limits, const MapState& map, double inflation);

  PoseEstimate robot() const;
  std::size_t landmarks() const { return ids_.size(); }
  /// The number of the landmark with this id.
  std::optional<std::size_t> find(LandmarkId id) const;
  LandmarkId id(std::size_t landmark) const { return ids_[landmark]; }
  LandmarkId freeId() const { return largest_id_ + 1; }
  Eigen::Vector2d point(std::size_t landmark) const { return graph_.point(keys_[landmark]); }
  /// The covariance of the robot, as a twist in its frame, and of some landmarks, one after
  /// another.
  Eigen::MatrixXd covariance(const std::vector<std::size_t>& landmarks) const;
  Eigen::Matrix2d covariance(std::size_t landmark) const {
    return graph_.covariance({keys_[landmark]});
  }

  /// @return what it makes of an error of the pose
  PosePrediction predict(const Motion& motion);
  /// The robot is redrawn there; the map does not move.
  void relocate(const PoseEstimate& robot);
  void observe(const std::vector<Match>& matches, const Pose2& sensor);
  /// A landmark at a place [m] where an observation puts it.
  void append(LandmarkId id, const Eigen::Vector2d& place, const LandmarkObservation& z,
              const Pose2& sensor);
  /// What is known of a landmark is forgotten; it begins again at this place.
  void reinitialize(std::size_t landmark, const Eigen::Vector2d& place,
                    const LandmarkObservation& z, const Pose2& sensor);
  /// @param most_iterations at most so many
  void optimize(int most_iterations);
  /// The robot's pose now is one of the path.
  void mark(Stamp stamp);

  LandmarkMap map() const;  ///< sorted by id, with marginals
  MapState state() const;   ///< sorted by id, with the joint covariance
  std::vector<StampedPose> path() const;
  std::size_t nodes() const { return nodes_; }
  const graph::Optimizer& graph() const { return graph_; }

 private:
  /// A pose of the path: relative to a node, or in the map where there was none yet.
  struct Mark {
    Stamp stamp;
    graph::Key node;
    Pose2 relative;
  };
  /// What the last node knows of a landmark.
  struct Sighting {
    graph::FactorId factor;
    LandmarkObservation z;
    Pose2 sensor;  ///< T_node_sensor
  };

  graph::Key addLandmark(LandmarkId id, const Eigen::Vector2d& place);
  PoseEstimate base() const;
  void requireNode();
  bool nodeIsDue() const;
  void addNode();
  LandmarkObservation carriedBack(const LandmarkObservation& z, const Pose2& sensor) const;
  void see(std::size_t landmark, const LandmarkObservation& z, const Pose2& sensor);
  std::vector<std::size_t> orderById() const;

  NodeLimits limits_;
  graph::Optimizer graph_;
  std::vector<LandmarkId> ids_;   ///< by number
  std::vector<graph::Key> keys_;  ///< by number
  LandmarkId largest_id_ = kUnknownId;
  std::unordered_map<LandmarkId, std::size_t> number_;    // looked up only, never iterated
  std::vector<std::vector<graph::FactorId>> factors_of_;  ///< by landmark

  PoseEstimate start_;                                   ///< of the robot, while there is no node
  std::optional<graph::Key> node_;                       ///< the last one
  std::optional<Motion> motion_;                         ///< since then
  std::unordered_map<std::size_t, Sighting> sightings_;  ///< of the last node, by landmark
  std::vector<Mark> marks_;
  std::size_t nodes_ = 0;
};

}  // namespace slam::graph_slam
