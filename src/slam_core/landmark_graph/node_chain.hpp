// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "slam_core/graph/calibrated_factors.hpp"
#include "slam_core/graph/optimizer.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::graph_slam {
struct SessionParts;
}

namespace slam::landmark_graph {

/// The nodes of the path in the order in which the robot passed them, with the factors of motion
/// that join them. A node between two others can be removed: the motions beside it become one. A
/// chord is a second motion to a node, from one further back; it goes with either of its nodes.
class NodeChain {
 public:
  /// A link is the motion to a node from the one before.
  struct Link {
    graph::FactorId factor = -1;
    graph::WheelMotion motion;  ///< depends on the wheels' parameters where they are calibrated
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the increment, to the first order
    double way = 0.0;                                      ///< driven, along all nodes between [m]

    template <class Archive>
    void persist(Archive& archive) {
      archive(factor, motion, covariance, way);
    }
  };
  struct Chord {
    graph::FactorId factor = -1;
    graph::Key other = -1;  ///< the node at its other end

    template <class Archive>
    void persist(Archive& archive) {
      archive(factor, other);
    }
  };
  struct Node {
    graph::Key before = -1, after = -1;
    Link link;                  ///< to the one before, where there is one
    bool has_prior = false;     ///< something besides motions and sightings says where it is
    std::vector<Chord> chords;  ///< from it and to it

    template <class Archive>
    void persist(Archive& archive) {
      archive(before, after, link, has_prior, chords);
    }
  };

  /// @param graph outlives this
  explicit NodeChain(graph::Optimizer& graph) : graph_(graph) {}

  /// From now on motions depend on parameters.
  /// @param wheels the keys of (kWheelScale, kWheelBase) and (kWheelDrift, kSensorYaw)
  void calibrate(const std::vector<graph::Key>& wheels) { wheels_ = wheels; }
  /// The path goes on from a node that has a prior of its own.
  void start(graph::Key node);
  /// Adds the factor of the motion from one node to a new one.
  /// @param by_wheels the same motion, with its Jacobian where the wheels are calibrated
  void append(graph::Key before, graph::Key node, const Motion& motion,
              const graph::WheelMotion& by_wheels = {});
  /// Adds a second motion to a node. @param W its weight, as of graph::Between
  void addChord(graph::Key from, graph::Key node, const Pose2& motion, const Eigen::Matrix3d& W);
  /// Makes the motion to a node from the one before less certain.
  /// @param more is added to its covariance, of the twist at the node
  void loosen(graph::Key node, const Eigen::Matrix3d& more);
  const Node& operator[](graph::Key node) const { return nodes_.at(node); }
  std::size_t size() const { return nodes_.size(); }
  /// The nodes that have come since the last call, in order.
  std::vector<graph::Key> takeNew() { return std::exchange(new_, {}); }

  /// Removes the motion between a node and the one before.
  friend void separate(NodeChain& chain, graph::Key node) { chain.cut(node); }
  /// Removes a node with its variable and chords. No factors but those of motion hold it any more.
  void remove(graph::Key node);

  template <class Archive>
  void persist(Archive& archive) {
    archive(nodes_, new_, wheels_);
  }

 private:
  friend struct graph_slam::SessionParts;  // takes up the nodes of a session as if they had just
                                           // come

  void join(graph::Key before, graph::Key node, const Link& link);
  std::shared_ptr<const graph::Factor> factorOf(graph::Key before, graph::Key node,
                                                const Link& link) const;
  /// The motion at the parameters as they are now.
  Link renewed(Link link) const;
  void cut(graph::Key node);
  void removeChords(graph::Key node);

  graph::Optimizer& graph_;
  std::unordered_map<graph::Key, Node> nodes_;  // looked up only, never iterated
  std::vector<graph::Key> new_;
  std::vector<graph::Key>
      wheels_;  ///< the keys of the parameters; empty where nothing is calibrated
};

}  // namespace slam::landmark_graph
