// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam::tuning {

/// The readings of a log whose landmark was out of view before: they show what the filter predicted
/// over a while. The errors of readings that follow one another are alike with most sensors (from
/// one place a marker is misread in one way); what a reading says of the next one is then no
/// measure of its noise.
class Resightings {
 public:
  /// In the order of stamps.
  void add(const LandmarkObservationArray& array);
  bool has(Stamp stamp, LandmarkId id) const { return found_.count({stamp, id}) > 0; }
  std::size_t size() const { return found_.size(); }

 private:
  std::map<LandmarkId, Stamp> last_;
  std::set<std::pair<Stamp, LandmarkId>> found_;
};

/// The log-likelihood of the steps of one run.
class InnovationScore {
 public:
  /// @param only these count, each for itself; else all innovations of a step together
  explicit InnovationScore(const Resightings* only) : only_(only) {}

  double of(const StepReport& report);
  int innovations() const { return innovations_; }  ///< that counted so far

 private:
  const Resightings* only_;
  int innovations_ = 0;
};

}  // namespace slam::tuning
