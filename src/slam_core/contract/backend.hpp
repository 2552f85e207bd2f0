// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "slam_core/contract/capabilities.hpp"
#include "slam_core/contract/component.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam {

/// The role of a SLAM back-end (thesis 3.4.2): data come in by its ports, a pose in a map comes
/// out. What else it can do it offers as capabilities.
///
/// Who calls: the Estimator, from one thread, in the order configure(), then for each step the
/// inputs since the last one, a trigger last, and execute(). It owns the back-end. Inputs come in
/// the order of stamps and are free of faults; at most one trigger comes before an execute().
/// Carriers add up. Ids of an observation array are sorted and may repeat.
///
/// A new back-end derives from this, registers itself (contract/registry.hpp) and must pass the
/// contract suites of what it offers.
class Backend : public Component {
 public:
  static constexpr const char* kRole = "back-end";

  using Component::describe;
  /// What it can do beyond this interface; as describe(Ports&), of what it is.
  virtual void describe(Capabilities& /*capabilities*/) {}
  /// Names all its random streams from the next configure() or reset() on. Back-ends that draw
  /// nothing do not need it.
  virtual void seed(std::uint64_t /*seed*/) {}

  /// The robot is re-drawn there with the next execute(); the map is kept, correlations to it are
  /// removed.
  virtual void set(const PoseEstimate& initial_pose) = 0;
  virtual PoseEstimate pose() const = 0;  ///< in the map frame
};

/// What a back-end can do. It holds pointers to the back-end.
inline Capabilities capabilitiesOf(Backend& backend) {
  Capabilities capabilities;
  backend.describe(capabilities);
  return capabilities;
}

/// A capability that the back-end is known to offer.
template <class Capability>
Capability& as(Backend& backend) {
  return *capabilitiesOf(backend).find<Capability>();
}

}  // namespace slam
