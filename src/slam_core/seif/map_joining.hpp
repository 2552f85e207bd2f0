// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/graph/local_map.hpp"

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

/// What two parts have in common.
struct SharedPart {
  SharedPart(const MappedPart& first, const MappedPart& second);
  std::vector<std::size_t> in_first, in_second;  ///< the places of the same landmarks
  std::vector<graph::Key> poses;
};

/// Whether these points alone say where the base of a local map is relative to them: its heading
/// by a sigma of 0.03 rad.
bool determinesBase(const graph::LocalMap& map, const std::vector<std::size_t>& points);

/// Two parts as one in the first one's frame: poses and points of the first, then those that only
/// the second one has (map joining: Tardos, Neira, Newman, Leonard 2002; by least squares: Huang,
/// Wang, Dissanayake 2008).
/// @param marginalised poses that are left out
/// @param largest_heading sigma of the one base's heading relative to the other's [rad]
/// @return nothing where what they share does not say how they lie to one another, or less
/// certainly than that, or where the points that come of it are bent more than a Gaussian says
std::optional<MappedPart> joined(const MappedPart& first, const MappedPart& second,
                                 const std::vector<graph::Key>& marginalised,
                                 double largest_heading);

}  // namespace slam::seif
