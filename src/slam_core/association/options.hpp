// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/association/association_policy.hpp"

namespace slam::association {

/// A landmark within the gate of an observation.
struct Option {
  std::size_t landmark = 0;
  Eigen::Vector2d nu;
  Eigen::Matrix2d S;
  double log_noise = 0.0;  ///< ln |R|, R the observation's noise
  /// nu^T S^-1 nu + ln(|S| / |R|) + descriptor_cost: twice the negative log-likelihood but for a
  /// constant of the observation. Never negative, as S holds R.
  double cost = 0.0;
  double descriptor_cost = 0.0;
};

/// What the observations of a stamp may be of by their places.
class Options {
 public:
  /// @param gate largest squared Mahalanobis distance of an option
  /// @param ring no landmark is begun within so many times the gate's radius
  void gather(const LandmarkObservationArray& array, const CandidateSource& source, double gate,
              double ring);

  std::size_t size() const { return of_.size(); }
  /// @return the options of an observation, the most likely one first
  const std::vector<Option>& of(std::size_t observation) const { return of_[observation]; }
  /// What an observation is that is taken for none of its options: new, far from all that is known,
  /// or clutter.
  Decision unpaired(std::size_t observation, bool map_is_fixed) const;
  /// Whether the second option is nearly as likely as the first one.
  bool isAmbiguous(std::size_t observation, double margin) const;

 private:
  void add(std::size_t observation, const LandmarkObservation& z, double gate, double ring_gate);

  std::vector<std::vector<Option>> of_;  ///< by observation
  std::vector<char> is_near_;            ///< a landmark is within the ring, by observation
  std::vector<Candidate> candidates_;
};

}  // namespace slam::association
