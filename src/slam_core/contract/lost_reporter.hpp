// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// The capability of a back-end that tests whether the robot is where it takes itself to be.
class LostReporter {
 public:
  virtual ~LostReporter() = default;
  /// Nothing while the pose is believed.
  virtual std::optional<Stamp> lostSince() const = 0;
  /// Whether the back-end looks for the robot by itself. Else who has its map does (Relocaliser).
  virtual bool findsItself() const { return false; }
};

}  // namespace slam
