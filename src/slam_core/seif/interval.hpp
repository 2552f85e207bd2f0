// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/seif/local_maps.hpp"

namespace slam::seif {

/// When an interval ends.
struct IntervalLimits {
  std::size_t landmarks = 30;  ///< more than so many were observed
  std::size_t nodes = 100;     ///< the path has so many poses
  double heading = 0.05;       ///< it is less certain how the robot has turned [rad]
};

/// The way of the newest landmarks, which alone the filter still has the poses of. When it ends,
/// its poses are marginalised: what is left is a Gaussian over the landmarks that were observed and
/// the last pose, the local map of the interval, in the last pose's frame. From there the next
/// interval goes on.
///
/// When that one ends as well, the pose between the two is let go of, as in the exactly sparse
/// filter (Walter, Eustice, Leonard 2007): marginalising it would join the landmarks of both
/// intervals. Its motion to the next pose is left out, and both local maps are from then on placed
/// by what they share with the rest of the map alone. Leaving out a measurement makes no estimate
/// over-confident. Where landmarks do not say how the interval lies in the map, the pose stays, as
/// one of both local maps.
class Interval {
 public:
  /// @param path, landmarks, maps outlive this
  Interval(const IntervalLimits& limits, landmark_graph::PathGraph& path,
           landmark_graph::LandmarkGraph& landmarks, LocalMaps& maps)
      : limits_(limits), path_(path), landmarks_(landmarks), maps_(maps) {}

  /// To be called when a step has added to path and landmarks, before it is solved.
  void follow();
  /// @return the variables of the landmarks that are near the robot, to be eliminated last
  std::vector<graph::Key> active() const;
  /// @return the landmarks that were observed in it, in the order of their first observation
  const std::vector<std::size_t>& observed() const { return observed_; }
  /// Ends the interval if it is full. To be called when the graph is solved, and before what is
  /// observed after a motion is added: a motion that is too uncertain belongs to no interval that
  /// has observations on both of its sides.
  /// @return whether it has ended, so that the graph has to be solved again
  bool endWhereFull();
  /// The path is about to go on elsewhere.
  void endForGood();

  template <class Archive>
  void persist(Archive& archive) {
    archive(nodes_, observed_, previous_, factor_, joint_);
  }

 private:
  bool isFull() const;
  double headingSigma() const;
  MappedPart marginalised(bool with_joint) const;
  MappedPart ended();
  bool isTied(const MappedPart& part) const;
  void letGo();
  MappedPart withJoint(const MappedPart& part) const;
  void keepJoint();
  std::optional<MappedPart> continued(const MappedPart& part);
  void consume();
  void see(graph::Key node);

  IntervalLimits limits_;
  landmark_graph::PathGraph& path_;
  landmark_graph::LandmarkGraph& landmarks_;
  LocalMaps& maps_;
  std::vector<graph::Key> nodes_;  ///< of this interval
  std::vector<std::size_t> observed_;
  /// The local map of the interval before, while its last pose is there, and its factor.
  std::optional<MappedPart> previous_;
  graph::FactorId factor_ = -1;
  graph::Key joint_ = -1;  ///< the pose between the two
};

}  // namespace slam::seif
