// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <set>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::relocalisation {

/// The observations of one step, which were associated by place.
struct View {
  std::set<LandmarkId> known;  ///< landmarks of the map that observations were taken for
  std::size_t others = 0;      ///< observations that were taken for none

  template <class Archive>
  void persist(Archive& archive) {
    archive(known, others);
  }
};

/// Judges whether the view has changed at once although the robot has hardly moved: the landmarks
/// of a view are gone, and something else is seen in their place, in several views one after the
/// other. Then the robot has been carried away, or its sensor turned. Objects that come between
/// hide landmarks as well, but do not put others there.
///
/// How often a landmark is still seen in the next view, and how many observations are of none, is
/// learnt while the robot is at its estimated pose, of changed views only where the next ones show
/// that they were passing.
class ViewChange {
 public:
  /// The log-likelihood ratio of "lost" to "right", 0 or above; 0 where the robot has moved, or
  /// where there were few landmarks before.
  /// @param robot T_map_base of the back-end after the step
  /// @param is_right whether it counts as being there, so that its view is learnt from
  double judge(const View& view, const Pose2& robot, bool is_right);
  /// The next view is compared with none before it.
  void forgetBefore() { robot_.reset(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(before_, robot_, kept_, known_, new_kept_, new_known_, changed_, evidence_);
  }

 private:
  /// Counts how often something was so and how often it was not. The counts begin with a guess.
  struct Rate {
    double yes, no;

    double share() const { return yes / (yes + no); }
    void learn(const Rate& more);

    template <class Archive>
    void persist(Archive& archive) {
      archive(yes, no);
    }
  };

  bool isNear(const Pose2& robot) const;
  std::size_t keptOf(const View& view) const;
  double evidenceOf(const View& view) const;
  void note(const View& view);
  double begin(const View& view, const Pose2& robot);

  View before_;                 ///< the last one that had not changed
  std::optional<Pose2> robot_;  ///< there
  Rate kept_{7.0, 3.0};         ///< landmarks of a view that the next one holds as well
  Rate known_{7.0, 3.0};        ///< observations that are taken for a landmark
  Rate new_kept_{0.0, 0.0}, new_known_{0.0, 0.0};  ///< of the views since then
  int changed_ = 0;                                ///< views since then
  double evidence_ = 0.0;                          ///< the least of them
};

}  // namespace slam::relocalisation
