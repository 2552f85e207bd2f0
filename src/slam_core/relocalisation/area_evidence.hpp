// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <utility>

namespace slam::relocalisation {

/// Sums up what surfaces that are seen for the first time tell of a place in a map. Surfaces that
/// are near one another are not independent: a room that looks like the robot's one up to some
/// point often looks like it in the next corner as well, and then all that stands there agrees. So
/// each area tells a limited amount for a place, however much is seen in it, and a place is only
/// believed after several areas have been seen. Against a place an area tells without a limit.
class AreaEvidence {
 public:
  using Patch = std::pair<int, int>;  ///< of the map's plane

  /// @param log_ratio logarithm of how many times likelier what was seen in the patch is in the
  /// right place than in one that looks alike up to there and is independent in this area
  /// @return by how much the logarithm of how many times likelier all of it is in the right place
  /// than in one that looks alike has changed
  double add(const Patch& patch, double log_ratio);

  template <class Archive>
  void persist(Archive& archive) {
    archive(areas_);
  }

 private:
  std::map<Patch, double> areas_;  ///< sums of log_ratio
};

}  // namespace slam::relocalisation
