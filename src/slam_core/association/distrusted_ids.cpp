// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/distrusted_ids.hpp"

#include <string>

namespace slam::association {
namespace {

/// Doubts about an id: each wrong first place, each move of a confirmed landmark, and as many as
/// are too many. A right id of a detector that misreads every fifth one stays below.
constexpr int kWrongPlace = 1, kMove = 3, kTooMany = 8;

}  // namespace

void DistrustedIds::refuse(const LandmarkObservationArray& array,
                           std::vector<Decision>& decisions) const {
  if (doubts_.empty()) return;
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (has(array.observations[i].id)) decisions[i] = {Decision::Kind::kDistrusted, 0};
}

bool DistrustedIds::count(LandmarkId id, bool was_confirmed) {
  doubts_[id] += was_confirmed ? kMove : kWrongPlace;
  return has(id);
}

bool DistrustedIds::has(LandmarkId id) const {
  const auto found = doubts_.find(id);
  return found != doubts_.end() && found->second >= kTooMany;
}

Status DistrustedIds::warningOf(LandmarkId id) {
  return Status::warning("landmark " + std::to_string(id) +
                         " was repeatedly found elsewhere: do several markers have this id, "
                         "or none? It is not used any more");
}

}  // namespace slam::association
