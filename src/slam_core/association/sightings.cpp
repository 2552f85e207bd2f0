// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/sightings.hpp"

#include <algorithm>
#include <string>

namespace slam::association {

Sightings::Sightings(const LandmarkMap& map) {
  for (const auto& landmark : map) records_[landmark.id].fits = kConfirmed;
}

Sightings::Record Sightings::record(LandmarkId id) const {
  const auto found = records_.find(id);
  return found == records_.end() ? Record() : found->second;
}

bool Sightings::isConfirmed(LandmarkId id) const {
  const auto found = records_.find(id);
  return found != records_.end() && found->second.fits >= kConfirmed;
}

bool Sightings::robotIsWhereItShould(const std::vector<LandmarkId>& fitting,
                                     std::size_t gated) const {
  const auto witnesses = static_cast<std::size_t>(std::count_if(
      fitting.begin(), fitting.end(), [this](LandmarkId id) { return isConfirmed(id); }));
  return witnesses > 0 && witnesses >= gated;
}

Sightings::Verdict Sightings::judge(const std::vector<LandmarkId>& fitting,
                                    const std::vector<LandmarkObservation>& gated) {
  Verdict verdict;
  const bool counts = robotIsWhereItShould(fitting, gated.size());
  for (const auto id : fitting) {
    auto& record = records_[id];
    record = {std::min(record.fits + 1, kConfirmed), 0};
  }
  if (!counts) return verdict;
  for (const auto& z : gated) {
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

Status Sightings::warningOf(const Verdict& verdict, const std::vector<LandmarkId>& reinitialized) {
  if (!reinitialized.empty()) {
    std::string ids;
    for (const auto id : reinitialized) ids += (ids.empty() ? "" : ", ") + std::to_string(id);
    return Status::warning("landmark " + ids +
                           " was hardly ever where the map had it: it is begun anew");
  }
  if (verdict.times == 0) return Status::ok();
  return Status::warning("landmark " + std::to_string(verdict.moved) +
                         " was not where the map has it " + std::to_string(verdict.times) +
                         " times in a row: was it moved?");
}

}  // namespace slam::association
