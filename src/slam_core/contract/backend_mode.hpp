// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/choice.hpp"

namespace slam {

/// What a back-end does with its map: build it, or keep a loaded one and only localise in it. It is
/// the key `mode` in every back-end's section.
enum class BackendMode { kSlam, kLocalization };

inline const Names<BackendMode>& backendModeNames() {
  static const Names<BackendMode> kNames = {{"slam", BackendMode::kSlam},
                                            {"localization", BackendMode::kLocalization}};
  return kNames;
}

}  // namespace slam
