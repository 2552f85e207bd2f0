// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/graph/local_map.hpp"
#include "slam_core/landmark_graph/landmark_graph.hpp"

namespace slam::seif {

/// A local map with the landmarks that its points are, and the keys of its poses.
struct MappedPart {
  graph::LocalMap map;
  std::vector<std::size_t> landmarks;  ///< by point
  std::vector<graph::Key> poses;       ///< by pose

  template <class Archive>
  void persist(Archive& archive) {
    archive(map, landmarks, poses);
  }
};

/// What the map has kept of the way: local maps of which nothing but the landmarks is left. Each of
/// them joins no more than a bounded number of landmarks in the information matrix, and two that
/// have so few together become one: so the matrix stays sparse, and grows with the map and not with
/// the way.
class LocalMaps {
 public:
  /// @param most_landmarks that two maps may have together to be joined @param path, landmarks
  /// outlive this
  LocalMaps(std::size_t most_landmarks, landmark_graph::PathGraph& path,
            landmark_graph::LandmarkGraph& landmarks)
      : most_landmarks_(most_landmarks), path_(path), landmarks_(landmarks) {}

  /// Adds what nothing but the landmarks is left of.
  void add(MappedPart part);
  /// Whether the map says something of the landmark that the way now does not.
  bool knows(std::size_t landmark) const;
  std::size_t size() const { return size_; }
  /// The most landmarks that one of them joins.
  std::size_t largest() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(parts_, of_landmark_, free_, size_);
  }

 private:
  /// A part with its factor; -1: there is none at this place.
  struct Stored {
    MappedPart part;
    graph::FactorId factor = -1;

    template <class Archive>
    void persist(Archive& archive) {
      archive(part, factor);
    }
  };
  /// @return the places of those that share a landmark, rising
  std::vector<std::size_t> around(const MappedPart& part) const;
  bool join(MappedPart& part);
  void store(MappedPart part);
  void remove(std::size_t place);

  std::size_t most_landmarks_;
  landmark_graph::PathGraph& path_;
  landmark_graph::LandmarkGraph& landmarks_;
  std::vector<Stored> parts_;
  std::vector<std::vector<std::size_t>> of_landmark_;  ///< places of the parts that have it
  std::vector<std::size_t> free_;                      ///< places without a part
  std::size_t size_ = 0;
};

}  // namespace slam::seif
