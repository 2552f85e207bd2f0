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

std::vector<Sightings::Verdict> Sightings::judge(const std::vector<LandmarkId>& fitting,
                                                 const std::vector<LandmarkObservation>& gated) {
  std::vector<Verdict> verdicts;
  const bool counts = robotIsWhereItShould(fitting, gated.size());
  for (const auto id : fitting) {
    auto& record = records_[id];
    record = {std::min(record.fits + 1, kConfirmed), 0};
  }
  if (!counts) return verdicts;
  for (const auto& z : gated) {
    auto& record = records_[z.id];
    ++record.misses;
    const bool was_confirmed = record.fits >= kConfirmed;
    if (record.misses != (was_confirmed ? kMoved : kDoubtful)) continue;
    verdicts.push_back({z, was_confirmed});
    if (!was_confirmed) record = {};
  }
  return verdicts;
}

Status Sightings::warningOf(const Verdict& verdict, bool is_reinitialized) {
  const auto name = "landmark " + std::to_string(verdict.z.id);
  if (!verdict.was_confirmed)
    return is_reinitialized
               ? Status::warning(name + " repeatedly failed its gate: it is re-initialised")
               : Status::ok();
  if (is_reinitialized)
    return Status::warning(name +
                           " was repeatedly seen elsewhere: it was moved, and is re-initialised "
                           "where it is now");
  return Status::warning(name + " was not where the map has it " + std::to_string(kMoved) +
                         " times in a row: was it moved?");
}

}  // namespace slam::association
