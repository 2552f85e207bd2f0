// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <map>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// Counts how many of the last observations of known landmarks failed the chi-square gate. In a
/// filter that has lost its pose only this rate shows it: gated observations do not correct the
/// filter, and the innovations of the few that pass the gate are small.
///
/// The gate rejects right observations with a known probability, and a healthy sensor may add a
/// share of wrong ones (kOutliers). The errors of one landmark are correlated, as it may have been
/// moved: each landmark counts for kMostOfOne trials at most. The rate is excessive if most
/// observations, in most steps, were gated, and if the probability of so many is below kFalseAlarm
/// according to the binomial distribution.
class GatingRate {
 public:
  static constexpr double kOutliers = 0.2, kFalseAlarm = 1e-6;
  static constexpr int kMostOfOne = 5, kFewestSteps = 5;

  /// @param window steps with observations of known landmarks
  explicit GatingRate(int window = 50) : window_(static_cast<std::size_t>(window)) {}

  /// To be called once for each step. Steps without observations of known landmarks are ignored.
  void add(const UpdateStatistics& statistics);

  int observations() const { return all_.seen; }
  int gated() const { return all_.gated; }
  bool isExcessive() const;
  /// Whether most observations of the latest step were gated, so that the noise should not be
  /// judged by it.
  bool isLatestMostlyGated() const {
    return !steps_.empty() && countOf(steps_.back()).isMostlyGated();
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(gate_probability_, steps_, landmarks_, all_, doubtful_steps_);
  }

 private:
  struct Count {
    int seen = 0, gated = 0;
    bool isMostlyGated() const { return 2 * gated > seen; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(seen, gated);
    }
  };
  struct Observation {
    LandmarkId id = kUnknownId;
    bool used = false;

    template <class Archive>
    void persist(Archive& archive) {
      archive(id, used);
    }
  };
  using Step = std::vector<Observation>;
  static Count countOf(const Step& step);
  void count(const Step& step, int sign);
  double probability() const;

  std::size_t window_;
  double gate_probability_ = 1.0;  ///< of the last update
  std::deque<Step> steps_;
  std::map<LandmarkId, Count> landmarks_;
  Count all_;
  int doubtful_steps_ = 0;  ///< steps of which most observations were gated
};

}  // namespace slam
