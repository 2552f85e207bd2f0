// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/sightings.hpp"

#include <algorithm>

namespace slam::ekf {

Sightings::Sightings(const LandmarkMap& map) {
  for (const auto& landmark : map) records_[landmark.id].fits = kConfirmed;
}

bool Sightings::isConfirmed(LandmarkId id) const {
  const auto found = records_.find(id);
  return found != records_.end() && found->second.fits >= kConfirmed;
}

bool Sightings::robotIsWhereItShould(const Association& association) const {
  const auto witnesses = static_cast<std::size_t>(
      std::count_if(association.matches.begin(), association.matches.end(),
                    [this](const Match& match) { return isConfirmed(match.z.id); }));
  return witnesses > 0 && witnesses >= association.gated.size();
}

Sightings::Verdict Sightings::judge(const Association& association) {
  Verdict verdict;
  const bool counts = robotIsWhereItShould(association);
  for (const auto& match : association.matches) {
    auto& record = records_[match.z.id];
    record = {std::min(record.fits + 1, kConfirmed), 0};
  }
  if (!counts) return verdict;
  for (const auto& z : association.gated) {
    auto& record = records_[z.id];
    ++record.misses;
    if (record.fits >= kConfirmed) {
      if (record.misses < kMoved || record.misses <= verdict.times) continue;
      verdict.moved = z.id;
      verdict.times = record.misses;
    } else if (record.misses >= kDoubtful) {
      verdict.doubtful.push_back(z);
      record = {};
    }
  }
  return verdict;
}

}  // namespace slam::ekf
