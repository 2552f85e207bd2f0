// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/choice.hpp"

namespace slam {

/// How a product represents the map: point landmarks, or a grid that a laser's scans are drawn
/// into.
enum class MapKind { kLandmarks, kGrid };

inline const Names<MapKind>& mapKindNames() {
  static const Names<MapKind> kNames = {{"landmarks", MapKind::kLandmarks},
                                        {"grid", MapKind::kGrid}};
  return kNames;
}

}  // namespace slam
