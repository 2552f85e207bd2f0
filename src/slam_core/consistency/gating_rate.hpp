// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <map>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// How many of the last observations of known landmarks failed the chi-square gate. Of a filter
/// that has lost its pose this is all there is to see: what is gated corrects nothing, and what
/// little still passes fits.
///
/// The gate leaves out right observations with a known probability, and a healthy sensor may give a
/// share of wrong ones on top (kOutliers). The readings of one landmark are alike, it may have been
/// moved: each landmark counts for kMostOfOne trials at most. The rate is excessive where most
/// observations, in most steps, were gated and the binomial distribution gives so many a
/// probability below kFalseAlarm.
class GatingRate {
 public:
  static constexpr double kOutliers = 0.2, kFalseAlarm = 1e-6;
  static constexpr int kMostOfOne = 5, kFewestSteps = 5;

  /// @param window steps with observations of known landmarks
  explicit GatingRate(int window = 50) : window_(static_cast<std::size_t>(window)) {}

  /// Once for each step; steps without observations of known landmarks are passed over.
  void add(const UpdateStatistics& statistics);

  int observations() const { return all_.seen; }
  int gated() const { return all_.gated; }
  bool isExcessive() const;
  /// Whether most of the latest step was gated: no time to judge noise by.
  bool isLatestMostlyGated() const {
    return !steps_.empty() && countOf(steps_.back()).isMostlyGated();
  }

 private:
  struct Count {
    int seen = 0, gated = 0;
    bool isMostlyGated() const { return 2 * gated > seen; }
  };
  struct Observation {
    LandmarkId id = kUnknownId;
    bool used = false;
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
  int doubtful_steps_ = 0;  ///< of which most was gated
};

}  // namespace slam
