// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/contract/component.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {

/// An input gate. It converts what a driver sends, together with what must be known of the sensor,
/// such as its mount, into data that other components can use. The wiring places a gate before an
/// input that no component makes and whose kind the gate makes; all components with that input
/// share the gate.
class Gate : public Component {
 public:
  static constexpr const char* kRole = "gate";

  /// The name under which it is registered, and which its configuration section and its counters
  /// have.
  virtual std::string name() const = 0;
  /// Counts the data that wait, by what they wait for.
  virtual Counters held() const { return {}; }
};

/// A static object of this type registers a gate.
template <class Component>
using GateRegistrar = Registrar<Gate, Component>;

}  // namespace slam
