// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/status.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_core/relocalisation/relocaliser.hpp"

namespace slam {

/// A copy of the map of a back-end that was restored from a checkpoint, with the robot's pose. The
/// robot may have been moved since then, or its clock set back.
class SavedMap {
 public:
  explicit SavedMap(const Capabilities& backend);

  bool isEmpty() const { return map_.landmarks.empty() && !hasGrid() && !session_; }
  const MapState& map() const { return map_; }
  /// The session of a back-end that keeps sessions holds the map as well.
  const std::optional<SavedSession>& session() const { return session_; }
  /// The pose is not believed until the robot's place has been recognised in this map, unless the
  /// robot is searched for already.
  /// @return a warning where nothing can be searched, so that the pose is believed as it is
  Status doubt(relocalisation::Relocaliser& relocaliser) const;

 private:
  bool hasGrid() const { return map_.grid && !map_.grid->cells.empty(); }

  MapState map_;
  std::optional<SavedSession> session_;
};

}  // namespace slam
