// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/contract/component.hpp"
#include "slam_core/contract/id_range.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// What a detector tells of each landmark that it finds.
struct LandmarkTraits {
  bool has_descriptor = false;
};

/// The role of an allothetic source: raw data in, landmark observations out (thesis 3.4.1, 5.2), at
/// the output `observations`. What it takes in is its own affair: describe() says so.
///
/// Every input that is not late yields one array, an empty one where nothing is seen or the input
/// cannot be used: that, too, moves time on.
class LandmarkDetector : public Component {
 public:
  static constexpr const char* kRole = "detector";

  /// A loaded map is compared with this; known before configure().
  virtual LandmarkTraits traits() const { return {}; }
  /// To be called before configure() of a detector that stands beside another one in a product, so
  /// that an id is of one landmark only: families without an offset of their own begin here.
  virtual void startIdsAt(LandmarkId /*first*/) {}
  /// The ids of its landmarks by family, known after configure(); none where they have no ids.
  virtual std::vector<IdRange> ids() const { return {}; }
  bool isBusy() const override { return observations().has_value(); }
  /// What the last execute() made: nothing when no input was due.
  virtual const std::optional<LandmarkObservationArray>& observations() const = 0;
};

}  // namespace slam
