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

/// What every component of a product is (thesis 4.2.1): its data come in and go out by ports.
///
/// Who calls: the Wiring, from one thread (a back-end is called by the Estimator): an input's
/// set(...), then execute() until isBusy() is false; after each execute() the outputs are taken. A
/// component knows nothing of the others.
class Component {
 public:
  /// Names and values that show in the diagnostics how well the component works.
  using Figures = std::vector<std::pair<std::string, double>>;

  virtual ~Component() = default;

  /// Its inputs and outputs. They depend on what the component is, not on its configuration, so
  /// that a product's inputs are known before anything is configured.
  virtual void describe(Ports& ports) = 0;
  /// A fresh start. @throw ConfigError listing all faults of its sections
  virtual void configure(Settings& settings) = 0;
  /// One deterministic step with what was set.
  virtual Status execute() = 0;
  /// Whether another execute() follows although nothing more is set: the last one consumed one of
  /// several waiting inputs.
  virtual bool isBusy() const { return false; }

  virtual Counters counters() const = 0;
  /// Messages that had no effect because they came late, were lost or could not be used.
  virtual std::uint64_t dropped() const { return 0; }
  virtual Figures figures() const { return {}; }
  /// The component is as after configure(), but latched inputs (TimeRole::kLatched) stay in force.
  virtual void reset() = 0;

  /// Whether saveState() and restoreState() are there; known after configure(). A product of which
  /// one component cannot be resumed writes no checkpoints.
  virtual bool canResume() const { return false; }
  /// Between two executions, outputs taken: all that is known beyond the configuration.
  virtual void saveState(ArchiveWriter& /*archive*/) const {}
  /// The component, which is configured as the one that was saved, goes on as that one would.
  /// @throw std::runtime_error where the archive holds no such state; then only configure() helps
  virtual void restoreState(ArchiveReader& /*archive*/) {}
};

/// The ports of a component. They hold pointers to it.
inline Ports portsOf(Component& component) {
  Ports ports;
  component.describe(ports);
  return ports;
}

/// Sets the first input that takes this kind of data.
/// @throw std::logic_error where no input does
template <class T>
void give(const T& value, Component& component) {
  const auto ports = portsOf(component);
  for (const auto& input : ports.inputs())
    if (input.kind == kindOf<T>()) return input.set(&value);
  throw std::logic_error("no input takes " + nameOf(kindOf<T>()));
}

}  // namespace slam
