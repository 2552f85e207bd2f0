// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/contract/ports.hpp"

namespace slam {

/// The base of every component of a product (thesis 4.2.1): data come in and go out by ports.
///
/// Who calls: the Wiring, from one thread (a back-end is called by the Estimator): an input's
/// set(...), then execute() until isBusy() is false; after each execute() the outputs are taken. A
/// component does not know the others.
class Component {
 public:
  /// Names and values that show in the diagnostics how well the component works.
  using Figures = std::vector<std::pair<std::string, double>>;

  virtual ~Component() = default;

  /// Describes its inputs and outputs. They depend on the component's class, not on its
  /// configuration, so that a product's inputs are known before anything is configured.
  virtual void describe(Ports& ports) = 0;
  /// Reads its configuration and starts afresh. @throw ConfigError listing all faults of its
  /// sections
  virtual void configure(Settings& settings) = 0;
  /// Takes one deterministic step with the inputs that were set.
  virtual Status execute() = 0;
  /// Whether execute() is to be called again although nothing more was set: the last call consumed
  /// one of several waiting inputs.
  virtual bool isBusy() const { return false; }

  virtual Counters counters() const = 0;
  /// The number of messages that had no effect because they came late, were lost or could not be
  /// used.
  virtual std::uint64_t dropped() const { return 0; }
  virtual Figures figures() const { return {}; }
  /// Puts the component in the state after configure(), except that latched inputs
  /// (TimeRole::kLatched) stay in force.
  virtual void reset() = 0;

  /// Whether saveState() and restoreState() are implemented; known after configure(). If one
  /// component of a product cannot be resumed, the product writes no checkpoints.
  virtual bool canResume() const { return false; }
  /// Saves all that the component knows beyond its configuration. To be called between two
  /// executions, after the outputs were taken.
  virtual void saveState(ArchiveWriter& /*archive*/) const {}
  /// Restores a saved state. The component must be configured like the one that was saved, and goes
  /// on as that one would.
  /// @throw std::runtime_error if the archive holds no such state; then the component must be
  /// configured again
  virtual void restoreState(ArchiveReader& /*archive*/) {}
};

/// The ports of a component. They hold pointers to it.
inline Ports portsOf(Component& component) {
  Ports ports;
  component.describe(ports);
  return ports;
}

/// Sets the first input that takes this kind of data.
/// @throw std::logic_error if no input does
template <class T>
void give(const T& value, Component& component) {
  const auto ports = portsOf(component);
  for (const auto& input : ports.inputs())
    if (input.kind == kindOf<T>()) return input.set(&value);
  throw std::logic_error("no input takes " + nameOf(kindOf<T>()));
}

}  // namespace slam
