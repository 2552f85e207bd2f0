// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/contract/component.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {

/// A component between the sensors and the component that takes in its output, such as the
/// back-end. No product names it: the wiring adds it if an input needs data of the kind that it
/// makes, and no other component makes them. Unlike a gate it exists once in a product, in a
/// nodelet or a process of its own.
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
