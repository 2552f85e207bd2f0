// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// The capability of a back-end that divides the world into places and recognises them.
class PlaceReporter {
 public:
  virtual ~PlaceReporter() = default;
  /// When the place where the robot is now was visited first; nothing before the first place, and
  /// while the robot sees nothing that could be recognised.
  virtual std::optional<Stamp> place() const = 0;
};

}  // namespace slam
