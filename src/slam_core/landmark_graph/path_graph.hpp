// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/graph/optimizer.hpp"
#include "slam_core/landmark_graph/node_chain.hpp"
#include "slam_core/landmark_graph/parameter_variables.hpp"
#include "slam_core/landmark_graph/twist_covariance.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::graph_slam {
struct SessionParts;
}

namespace slam::landmark_graph {

/// When the graph gets a new pose: the robot has moved so far since the last one.
struct NodeLimits {
  double distance = 0.05;  ///< [m]
  double angle = 0.05;     ///< [rad]
};

/// The end of the path.
struct Tail {
  std::optional<graph::Key> node;  ///< the last one; none before the first one and where redrawn
  std::optional<Motion> motion;    ///< since then; nothing where the robot is there
  std::size_t nodes = 0;           ///< of the whole path, with those that were removed

  template <class Archive>
  void persist(Archive& archive) {
    archive(node, motion, nodes);
  }
};

/// The robot's path as a graph: a node for each pose from which something new was seen, and a
/// factor of motion between one and the next. The robot is where the last node and the motion since
/// then put it. Maps add what they need to the same graph.
class PathGraph {
 public:
  PathGraph(const NodeLimits& limits, const PoseEstimate& start,
            const graph::OptimizerLimits& optimizer = {})
      : limits_(limits), graph_(optimizer), start_(start) {}
  PathGraph(const PathGraph&) = delete;  // its chain holds its graph
  PathGraph& operator=(const PathGraph&) = delete;

  /// Parameters of wheels and sensor are estimated with the path from now on. Nothing else is in
  /// the graph, or what is there was loaded and depends on no parameter.
  friend void calibrate(PathGraph& path, const CalibrationEstimate& prior);
  /// Null where nothing is calibrated.
  friend const ParameterVariables* parametersOf(const PathGraph& path) {
    return path.parameters_ ? &*path.parameters_ : nullptr;
  }
  /// The parameters as they are estimated; 0 where nothing is calibrated.
  friend CalibrationVector calibrationOf(const PathGraph& path);

  /// The robot is there, or was there at a node.
  PoseEstimate robot(const std::optional<graph::Key>& at = {}) const;
  /// The covariance of the robot, as a twist in its frame, and of some variables of the graph.
  /// @param at a node where the robot was; where it is now without one
  Eigen::MatrixXd covariance(const std::vector<graph::Key>& keys,
                             const std::optional<graph::Key>& at = {}) const;

  /// @param J_wheels of the increment by (kWheelScale, kWheelBase, kWheelDrift), where these are
  /// calibrated; the motion is as it is with calibrationOf()
  /// @return what it makes of an error of the pose
  PosePrediction predict(const Motion& motion,
                         const Eigen::Matrix3d& J_wheels = Eigen::Matrix3d::Zero());
  /// The motion since the last node as something better tells it than odometry.
  void correct(const Pose2& increment, const Eigen::Matrix3d& covariance);
  /// The robot is redrawn there; what is in the graph does not move.
  void relocate(const PoseEstimate& robot);
  /// The robot is at this variable, which another factor tells.
  void relocate(graph::Key node);

  const Tail& tail() const { return tail_; }
  /// The covariance of the motion since the last node, as far as the parameters are in doubt, too.
  friend Eigen::Matrix3d tailCovarianceOf(const PathGraph& path);
  /// The last node; where the robot has moved beyond the limits it is a new one.
  graph::Key nodeNearby();
  graph::Key addNode();

  /// @param most_iterations at most so many
  /// @param others variables that the next factors will touch, beside the last node
  /// @param vicinity of all these
  void optimize(int most_iterations, const std::vector<graph::Key>& others = {},
                graph::Vicinity vicinity = {});

  graph::Optimizer& graph() { return graph_; }
  const graph::Optimizer& graph() const { return graph_; }
  friend NodeChain& chainOf(PathGraph& path) { return path.chain_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(graph_, chain_, start_, tail_, parameters_, by_wheels_);
  }

 private:
  friend struct graph_slam::SessionParts;  // writes and reads its members

  Eigen::MatrixXd withTail(const Eigen::MatrixXd& P) const;
  void renewTail();

  NodeLimits limits_;
  graph::Optimizer graph_;
  NodeChain chain_{graph_};
  PoseEstimate start_;  ///< of the robot, while there is no node
  Tail tail_;
  std::optional<ParameterVariables> parameters_;
  graph::WheelMotion by_wheels_;  ///< the motion of the tail, where parameters are estimated
};

}  // namespace slam::landmark_graph
