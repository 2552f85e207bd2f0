// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/saved_map.hpp"

#include <stdexcept>

namespace slam {
namespace {

using relocalisation::Belief;

constexpr const char* kBelieved =
    "where the robot went since the checkpoint is not known, and it cannot be searched for in the "
    "map, so that its pose is believed as it is: set an initial pose where the robot is elsewhere";

std::optional<SavedSession> sessionOf(const SessionKeeper& keeper) {
  try {
    return keeper.session();
  } catch (const std::runtime_error&) {
    return std::nullopt;  // there is nothing to save yet
  }
}

}  // namespace

SavedMap::SavedMap(const Capabilities& backend) {
  if (const auto* keeper = backend.find<MapKeeper>()) map_ = keeper->state();
  if (const auto* keeper = backend.find<SessionKeeper>()) session_ = sessionOf(*keeper);
}

Status SavedMap::doubt(relocalisation::Relocaliser& relocaliser) const {
  if (relocaliser.belief() != Belief::kSure) return Status::ok();
  relocaliser.assume(Belief::kUnconfirmed, &map_);
  const bool is_believed = relocaliser.belief() == Belief::kSure;
  const bool has_map = !map_.landmarks.empty() || hasGrid();
  return is_believed && has_map ? Status::warning(kBelieved) : Status::ok();
}

}  // namespace slam
