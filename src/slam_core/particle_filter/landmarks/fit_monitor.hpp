// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/particle_filter/landmarks/proposal.hpp"
#include "slam_core/particle_filter/particles/weights.hpp"

namespace slam::particle_filter {

/// How well the observations of a step were predicted by all particles together, and what follows
/// where they were not: one that is off may be a wrong reading, or the landmark was moved; but when
/// most of the established landmarks are not where they should be, it is the robot that is not
/// where it should be. Landmarks that are not established yet say nothing of that.
class FitMonitor {
 public:
  /// @param gate largest squared Mahalanobis distance of an observation that counts
  FitMonitor(double lost_nis, double gate) : lost_nis_(lost_nis), gate_(gate) {}

  /// To be called for each step. Fills in nis, nis_dof, used, gated, log_likelihood and the
  /// innovations. An observation counts as gated when the particles of more than half of the weight
  /// of those that take it for a landmark of their map gate it; where most of all do not, it is no
  /// observation of a known landmark.
  /// @param predictions of particle 0 for all observations, then of particle 1, ...
  /// @param weights before the step
  /// @return which observations were used
  std::vector<bool> judge(const std::vector<Prediction>& predictions,
                          const std::vector<LandmarkObservation>& seen, std::vector<double> weights,
                          UpdateStatistics& statistics);

  /// Whether the map had better be left as it is: most of the established landmarks of this step
  /// are off, or so were several and none has been seen in its place since.
  bool isDoubtful() const { return is_step_doubtful_ || hasGoneAstray(); }
  /// Whether the last observations were on average much worse than predicted, or doubt lasts.
  bool isLost() const;
  /// Of the last observations, for each degree of freedom; 1 expected.
  double recentNis() const { return dof_ > 0.0 ? nis_ / dof_ : 0.0; }
  /// A new place or map: what was seen before says nothing of it.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(nis_, dof_, is_step_doubtful_, gated_in_a_row_);
  }

 private:
  /// What a step says of its established landmarks.
  struct Established {
    int seen = 0, gated = 0;
  };
  bool hasGoneAstray() const;
  double count(const ObservationInnovation& innovation, UpdateStatistics& statistics) const;
  void remember(double nis);
  void conclude(const Established& established);

  double lost_nis_, gate_;
  double nis_ = 0.0, dof_ = 0.0;  ///< sums in which older observations count less
  bool is_step_doubtful_ = false;
  int gated_in_a_row_ = 0;  ///< of established landmarks, until most of a step's fit
};

}  // namespace slam::particle_filter
