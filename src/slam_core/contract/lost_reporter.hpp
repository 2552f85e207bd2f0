// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// The capability of a back-end that tests whether the robot is at its estimated pose.
class LostReporter {
 public:
  virtual ~LostReporter() = default;
  /// Since when the robot is lost; nothing while the pose is believed.
  virtual std::optional<Stamp> lostSince() const = 0;
  /// Whether the back-end looks for the robot by itself. Otherwise the Relocaliser does, in the
  /// back-end's map.
  virtual bool findsItself() const { return false; }
};

}  // namespace slam
