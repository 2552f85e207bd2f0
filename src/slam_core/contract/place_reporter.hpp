// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/common/time.hpp"

namespace slam {

/// A step, and when the place that was recognised in it was first visited.
struct PlaceVisit {
  Stamp stamp;
  std::optional<Stamp> first;  ///< nothing if no place was recognised or made
};

/// The capability of a back-end that divides the world into places and recognises them.
class PlaceReporter {
 public:
  virtual ~PlaceReporter() = default;
  /// All steps in their order, each as it was judged at the time.
  virtual std::vector<PlaceVisit> visits() const = 0;
};

}  // namespace slam
