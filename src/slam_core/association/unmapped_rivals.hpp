// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/joint_search.hpp"
#include "slam_core/association/options.hpp"

namespace slam::association {

/// Whether an observation may as well be of a landmark that is not in the map yet. After a way on
/// which nothing was seen the pose is uncertain, so that a landmark of the map may lie within the
/// gate of something that only looks like it, and there is no other candidate. A landmark that
/// is not in the map is then nearly as likely: its density is that of what the sensor sees at the
/// moment and what looks alike (the density of new targets: Reid 1979). A pairing that is not
/// certain on its own is left out, unless others of the same group (Jcbb) confirm it, and all such
/// pairings together are beyond chance: of the many ways to pair them some fit well by chance.
/// A stamp with few observations is not judged, since they cannot confirm one another.
class UnmappedRivals {
 public:
  /// @param probability that a descriptor passes its test @param margin as Option's costs have it
  void configure(double probability, double margin);
  /// Marks the choices that are ambiguous by this.
  void judge(const LandmarkObservationArray& array, const Options& options,
             const CandidateSource& source, std::vector<JointSearch::Choice>& choices);

 private:
  struct Paired {
    std::size_t choice;
    const Option* option;
    double rival;     ///< the cost of the rival
    bool is_certain;  ///< on its own
  };

  void gather(const LandmarkObservationArray& array, const Options& options,
              const std::vector<JointSearch::Choice>& choices);
  /// @param area in which the points lie [m^2]
  double densityOf(const LandmarkObservation& z, double area) const;
  void fillInformation(const CandidateSource& source,
                       const std::vector<JointSearch::Choice>& choices);
  void leaveOutUnconfirmed(const CandidateSource& source,
                           std::vector<JointSearch::Choice>& choices);
  /// @return the cost of the rival less that of the pairing given the others
  double gainOf(std::size_t pairing) const;
  /// @return the same of all pairings together that are not certain, given those that are
  double gainOfUncertain() const;

  double probability_ = 0.0, margin_ = 0.0;
  std::vector<LandmarkObservation> points_;  ///< of the stamp
  std::vector<Paired> paired_;
  Eigen::MatrixXd information_;  ///< of the innovations of all pairs
  Eigen::VectorXd weighted_;     ///< information times innovations
};

}  // namespace slam::association
