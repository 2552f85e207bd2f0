// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "slam_core/contract/capabilities.hpp"
#include "slam_core/contract/component.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam {

/// The role of a SLAM back-end (thesis 3.4.2): it takes in data by its ports and estimates a pose
/// in a map. It offers as capabilities what else it can do.
///
/// Who calls: the Estimator, which owns the back-end, from one thread. It first calls seed(), the
/// choosers (MapChooser, AssociationChooser), describe() and configure(). For each step it then
/// calls set() for every motion, set() for at most one trigger, and execute(). Several motions may
/// come in a step: the back-end applies all of them. A step may have no trigger; then the motions
/// alone are applied. After set() with an initial pose or a map, a separate execute() puts it in
/// force. Inputs come in the order of their stamps and are free of faults. The ids of an
/// observation array are sorted and may repeat.
///
/// A new back-end derives from this class, registers itself (contract/registry.hpp) and must pass
/// the contract suites of its capabilities.
class Backend : public Component {
 public:
  static constexpr const char* kRole = "back-end";

  using Component::describe;
  /// Names the capabilities that the back-end has beyond this interface. They depend on its class
  /// and on the map that was chosen, as its ports do, not on its configuration.
  virtual void describe(Capabilities& /*capabilities*/) {}
  /// Sets the seed of all random streams. Called before configure() (an OdometrySource is seeded
  /// after it). Back-ends without random numbers do not need it.
  virtual void seed(std::uint64_t /*seed*/) {}

  /// The next execute() replaces the robot's pose and covariance by these. The map is kept; its
  /// correlations with the robot become zero.
  virtual void set(const PoseEstimate& initial_pose) = 0;
  virtual PoseEstimate pose() const = 0;  ///< in the map frame
};

/// The capabilities of a back-end. They hold pointers to it.
inline Capabilities capabilitiesOf(Backend& backend) {
  Capabilities capabilities;
  backend.describe(capabilities);
  return capabilities;
}

/// A capability that the back-end is known to offer. The behaviour is undefined if it does not.
template <class Capability>
Capability& as(Backend& backend) {
  return *capabilitiesOf(backend).find<Capability>();
}

}  // namespace slam
