// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "slam_core/association/association_policy.hpp"

namespace slam::association::test {

/// A toy: each observation is of the nearest landmark, where that is near; where none is, it is of
/// a new one. Ids are not looked at.
class ToyNearest : public AssociationPolicy {
 public:
  /// @param near squared Mahalanobis distance
  explicit ToyNearest(double near = 100.0) : near_(near) {}

  bool usesPlaces() const override { return true; }
  void decide(const LandmarkObservationArray& array, const CandidateSource& source,
              bool map_is_fixed, std::vector<Decision>& decisions) override {
    decisions.assign(array.observations.size(), Decision());
    for (std::size_t i = 0; i < decisions.size(); ++i) {
      candidates_.clear();
      source.candidates(i, candidates_);
      const auto nearest =
          std::min_element(candidates_.begin(), candidates_.end(),
                           [](const auto& a, const auto& b) { return distance(a) < distance(b); });
      if (nearest != candidates_.end() && distance(*nearest) < near_)
        decisions[i] = {Decision::Kind::kLandmark, nearest->landmark};
      else
        decisions[i].kind = map_is_fixed ? Decision::Kind::kNotInMap : Decision::Kind::kNew;
    }
  }

 private:
  static double distance(const Candidate& candidate) {
    return candidate.nu.dot(candidate.S.llt().solve(candidate.nu));
  }

  double near_;
  std::vector<Candidate> candidates_;
};

/// Takes each observation for new, for a landmark that there is not, or says nothing at all.
class ToyNonsense final : public AssociationPolicy {
 public:
  bool usesPlaces() const override { return true; }
  void decide(const LandmarkObservationArray& array, const CandidateSource&, bool,
              std::vector<Decision>& decisions) override {
    decisions.assign(array.observations.size(), {Decision::Kind::kLandmark, 1000000});
    if (calls_ % 3 == 1) decisions.assign(array.observations.size(), {Decision::Kind::kNew, 0});
    if (calls_ % 3 == 2) decisions.clear();
    ++calls_;
  }

 private:
  int calls_ = 0;
};

/// One more observation, each time of nothing somewhere else.
inline void addClutter(int step, LandmarkObservationArray& array) {
  array.observations.push_back(array.observations.front());
  array.observations.back().range = 1.0 + 0.37 * (step % 11);
  array.observations.back().bearing = 0.6 * (step % 10) - 2.7;
}

inline void removeIds(LandmarkObservationArray& array) {
  for (auto& z : array.observations) z.id = kUnknownId;
}

}  // namespace slam::association::test
