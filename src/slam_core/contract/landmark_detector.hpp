// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/contract/component.hpp"
#include "slam_core/contract/id_range.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// What a detector reports of every landmark that it finds.
struct LandmarkTraits {
  bool has_descriptor = false;
};

/// The role of an allothetic source: raw data in, landmark observations out (thesis 3.4.1, 5.2), at
/// the output `observations`. describe() declares its inputs.
///
/// Every input that is not late yields one array. It is empty if nothing is seen or the input
/// cannot be used, since an empty array moves time on as well.
class LandmarkDetector : public Component {
 public:
  static constexpr const char* kRole = "detector";

  /// Known before configure(). A loaded map is compared with this.
  virtual LandmarkTraits traits() const { return {}; }
  /// The ids of families without an offset of their own begin here. To be called before
  /// configure(), for a second detector in a product, so that each id belongs to one landmark only.
  virtual void startIdsAt(LandmarkId /*first*/) {}
  /// The ids of its landmarks by family, known after configure(); none if they have no ids.
  virtual std::vector<IdRange> ids() const { return {}; }
  bool isBusy() const override { return observations().has_value(); }
  /// The output of the last execute(); nothing if no input was due.
  virtual const std::optional<LandmarkObservationArray>& observations() const = 0;
};

}  // namespace slam
