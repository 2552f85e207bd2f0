// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/common/time.hpp"

namespace slam {

/// A step of the way, and when the place where the robot took itself to be was visited first.
struct PlaceVisit {
  Stamp stamp;
  std::optional<Stamp> first;  ///< nothing where no place was recognised or made
};

/// The capability of a back-end that divides the world into places and recognises them.
class PlaceReporter {
 public:
  virtual ~PlaceReporter() = default;
  /// In their order, as they were taken at the time.
  virtual std::vector<PlaceVisit> visits() const = 0;
};

}  // namespace slam
