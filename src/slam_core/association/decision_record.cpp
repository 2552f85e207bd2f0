// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/decision_record.hpp"

namespace slam::association {
namespace {

TakenFor takenFor(Decision::Kind kind) {
  using Kind = Decision::Kind;
  switch (kind) {
    case Kind::kLandmark:
      return TakenFor::kLandmark;
    case Kind::kNew:
      return TakenFor::kNew;
    case Kind::kNotInMap:
      return TakenFor::kNotInMap;
    case Kind::kAmbiguous:
      return TakenFor::kAmbiguous;
    case Kind::kOnTrial:
      return TakenFor::kOnTrial;
    default:
      return TakenFor::kNothing;
  }
}

}  // namespace

std::string reasonOf(Decision::Kind kind) {
  using Kind = Decision::Kind;
  if (kind == Kind::kDuplicate) return "duplicate";
  if (kind == Kind::kNotInMap) return "not_in_map";
  if (kind == Kind::kAmbiguous) return "ambiguous";
  if (kind == Kind::kDistrusted) return "distrusted_id";
  return kind == Kind::kOnTrial ? "on_trial" : "unknown_id";
}

std::vector<AssociatedObservation> recordOf(const LandmarkObservationArray& array,
                                            const std::vector<Decision::Kind>& kinds) {
  std::vector<AssociatedObservation> record;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    record.push_back({array.observations[i].id, kUnknownId, takenFor(kinds[i])});
  return record;
}

}  // namespace slam::association
