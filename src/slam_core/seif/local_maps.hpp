// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/seif/map_joining.hpp"

namespace slam::seif {

/// When two local maps become one.
struct JoiningLimits {
  std::size_t landmarks = 45;  ///< together they have at most so many, poses included
  double heading = 0.05;       ///< sigma of the one's heading relative to the other's [rad]
};

/// What the map has kept of the way: local maps whose bases are marginalised. Each of them joins no
/// more than a bounded number of landmarks in the information matrix, and two that have so few
/// together become one: so the matrix stays sparse, and grows with the map and not with the way. A
/// pose between two local maps that nothing else ties to one another is kept until these two become
/// one.
class LocalMaps {
 public:
  /// @param path, landmarks outlive this
  LocalMaps(const JoiningLimits& limits, landmark_graph::PathGraph& path,
            landmark_graph::LandmarkGraph& landmarks)
      : limits_(limits), path_(path), landmarks_(landmarks) {}

  void add(MappedPart part);
  /// Two parts as one in the first one's frame, without these poses; nothing where the limits do
  /// not allow it.
  std::optional<MappedPart> joined(const MappedPart& first, const MappedPart& second,
                                   const std::vector<graph::Key>& marginalised) const;
  /// Whether the map says something of the landmark that the way now does not.
  bool knows(std::size_t landmark) const;
  /// @return these landmarks and those of the local maps that hold one of them, in increasing order
  std::vector<std::size_t> around(const std::vector<std::size_t>& landmarks) const;
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
  std::vector<std::size_t> partsWith(const std::vector<std::size_t>& landmarks) const;
  std::vector<graph::Key> jointsOf(const MappedPart& a, const MappedPart& b) const;
  bool join(MappedPart& part);
  void store(MappedPart part);
  void remove(std::size_t place);

  JoiningLimits limits_;
  landmark_graph::PathGraph& path_;
  landmark_graph::LandmarkGraph& landmarks_;
  std::vector<Stored> parts_;
  std::vector<std::vector<std::size_t>> of_landmark_;  ///< places of the parts that have it
  std::vector<std::size_t> free_;                      ///< places without a part
  std::size_t size_ = 0;
};

}  // namespace slam::seif
