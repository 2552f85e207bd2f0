// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/contract/component.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {

/// A component on the way from the sensors to who takes in what it makes, such as the back-end. No
/// product names it: it stands before each input of the kind that it makes, where no other
/// component makes that. Unlike a gate it stands once in a product and runs where the composition
/// puts it, in a nodelet or a process of its own.
class Stage : public Component {
 public:
  static constexpr const char* kRole = "stage";

  /// The name of its configuration section, and of its counters; it is registered under it.
  virtual std::string name() const = 0;
};

/// A static object of this type registers a stage.
template <class Component>
using StageRegistrar = Registrar<Stage, Component>;

}  // namespace slam
