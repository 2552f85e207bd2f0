// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/graph/vicinity.hpp"
#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/seif/local_maps.hpp"

namespace slam::seif {

/// The landmarks around the robot, which it may soon see. If it sees one of an earlier interval
/// that does not belong to them, the cliques between that landmark and the root have to be
/// computed. Then those of the landmarks around are computed with them, and all these are
/// eliminated last, so that the next landmarks that it sees change the top of the tree alone
/// (Guivant, Nebot 2001 keep a local area apart for the same reason). What is further away is
/// eliminated the earlier the further it is, by shells: a shell holds the cells of a grid around
/// the robot's cell, and the cells of the next one are twice as wide. The cost of a shell grows
/// with its width, and the robot needs the longer to come to it. The grid lies still while the
/// robot moves, so a new shell has its borders where earlier ones had theirs. If each shell were a
/// ring around the robot, the separators that earlier rings left would cross the new ones, and
/// cliques would be larger.
class Surroundings {
 public:
  /// @param most so many landmarks
  /// @param path, landmarks, maps outlive this
  Surroundings(std::size_t most, const landmark_graph::PathGraph& path,
               const landmark_graph::LandmarkGraph& landmarks, const LocalMaps& maps)
      : most_(most), path_(path), landmarks_(landmarks), maps_(maps) {}

  /// To be called before the graph is solved.
  /// @param observed landmarks of the interval
  graph::Vicinity follow(const std::vector<std::size_t>& observed);

  template <class Archive>
  void persist(Archive& archive) {
    archive(near_, radius_);
  }

 private:
  std::vector<graph::Key> gather(const std::vector<std::size_t>& observed,
                                 const Eigen::Vector2d& robot);

  std::size_t most_;
  const landmark_graph::PathGraph& path_;
  const landmark_graph::LandmarkGraph& landmarks_;
  const LocalMaps& maps_;
  std::vector<std::size_t> near_;  ///< in increasing order
  double radius_ = 1.0;            ///< in which they lay when they were gathered [m]
};

}  // namespace slam::seif
