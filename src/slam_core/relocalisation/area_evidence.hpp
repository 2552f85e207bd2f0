// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <utility>

namespace slam::relocalisation {

/// Sums up the evidence that newly seen surfaces give for or against a place in a map. Surfaces
/// near one another are not independent: a room that looks like the robot's one up to some point
/// often looks like it in the next corner as well, and then everything there agrees. So the
/// evidence of each area for a place is limited, however much is seen in the area, and a place is
/// believed only after several areas have been seen. The evidence of an area against a place is not
/// limited.
class AreaEvidence {
 public:
  using Patch = std::pair<int, int>;  ///< of the map's plane

  /// @param log_ratio log-likelihood ratio of what was seen in the patch: at the right place, over
  /// a place that has looked alike so far and is independent in this area
  /// @return the change of the log-likelihood ratio of all that was seen: at the right place, over
  /// a place that looks alike
  double add(const Patch& patch, double log_ratio);

  template <class Archive>
  void persist(Archive& archive) {
    archive(areas_);
  }

 private:
  std::map<Patch, double> areas_;  ///< sums of log_ratio
};

}  // namespace slam::relocalisation
