// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/contract/component.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {

/// A component that makes data of one kind fit for use, of what a driver sends and what must be
/// known of it, such as a mount. The wiring places one before an input that nobody makes and whose
/// kind it makes; all who take in that input share it.
class Gate : public Component {
 public:
  static constexpr const char* kRole = "gate";

  /// The name of its configuration section, and of its counters; it is registered under it.
  virtual std::string name() const = 0;
  /// Data that wait, by what for.
  virtual Counters held() const { return {}; }
};

/// A static object of this type registers a gate.
template <class Component>
using GateRegistrar = Registrar<Gate, Component>;

}  // namespace slam
