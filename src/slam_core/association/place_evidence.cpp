// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/place_evidence.hpp"

namespace slam::association {

void PlaceEvidence::see(const LandmarkObservationArray& array) {
  if (!is_needed_) return;
  auto points = array;
  std::vector<LandmarkObservation> lines;
  points.observations.clear();
  is_line_.clear();
  for (const auto& z : array.observations) {
    is_line_.push_back(z.isLine());
    (z.isLine() ? lines : points.observations).push_back(z);
  }
  reach_.see(points);
  trials_.see(points, reach_);
  line_trials_.see(lines, array.sensor_pose);
}

void PlaceEvidence::hold(const LandmarkObservationArray& array,
                         std::vector<Decision>& decisions) const {
  if (!is_needed_) return ids_.refuse(array, decisions);
  std::size_t point = 0, line = 0;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const bool is_confirmed =
        is_line_[i] ? line_trials_.isConfirmed(line++) : trials_.isConfirmed(point++);
    if (decisions[i].kind == Decision::Kind::kNew && !is_confirmed)
      decisions[i].kind = Decision::Kind::kOnTrial;
  }
}

}  // namespace slam::association
