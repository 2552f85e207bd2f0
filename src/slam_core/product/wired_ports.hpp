// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/gate.hpp"
#include "slam_core/contract/ports.hpp"

namespace slam {

/// The ports of all components and gates that are wired, seen as one: what the whole takes in and
/// makes, and who makes what. The wiring goes by them, and so does all that tells of a product.
class WiredPorts {
 public:
  /// A component or a gate.
  struct Part {
    std::string title;  ///< what sentences call it: "back-end 'ekf'"
    const Component* component;
    Ports ports;
    Gate* gate = nullptr;  ///< the same, of a gate

    bool makes(const std::string& output, Kind kind) const {
      return ports.output(output, kind) != nullptr;
    }
  };

  /// @param title what sentences call the component @param component outlives this
  /// @param ports its ports, with the names that they have in the product
  /// @return the ports, which stay in their place
  const Ports& add(const std::string& title, const Component& component, Ports ports);
  /// Adds a component whose ports keep their own names.
  const Ports& add(const std::string& title, Component& component) {
    return add(title, component, portsOf(component));
  }
  /// Adds a gate, not configured, before each input that nobody makes and that one is registered
  /// for; before those of a gate as well. A gate stands once, whatever it makes.
  /// @throw ConfigError where two gates have one name
  void placeGates();

  /// In the order in which they were added, then the gates.
  const std::deque<Part>& parts() const { return parts_; }
  const std::vector<std::unique_ptr<Gate>>& gates() const { return gates_; }
  /// Who makes the data of an input; null where they come from outside.
  const Part* makerOf(const InputPort& input) const {
    return slam::makerOf(parts_, input.name, input.kind);
  }

  /// The inputs in their order; of the same name and kind one, mandatory where it is so for anyone.
  std::vector<InputPort> inputs() const;
  /// Those of them that nobody makes.
  std::vector<InputPort> open() const;
  std::vector<OutputPort> outputs() const;
  /// Titles of those that take in an input: "the back-end 'ekf' and ...".
  std::string takersOf(const std::string& port, Kind kind) const;

  /// @throw ConfigError where two make the same output, and where parts take data from one another
  /// in a circle: data that came back to who made them would have no end within one process, and
  /// between several the result would depend on who is faster
  void requireJoinable() const;

 private:
  /// Refuses a part that makes what one before it makes.
  void requireOneMaker(const Part& part) const;

  std::deque<Part> parts_;  // a deque: parts are referred to
  std::vector<std::unique_ptr<Gate>> gates_;
};

/// Creates the component of a role that makes what an input takes in, not configured; null where
/// none is registered.
template <class Role>
std::unique_ptr<Role> createMakerOf(const InputPort& input) {
  const auto& registry = Registry<Role>::instance();
  for (const auto& name : registry.names()) {
    auto maker = registry.create(name);
    if (portsOf(*maker).output(input.name, input.kind) != nullptr) return maker;
  }
  return nullptr;
}

/// Whether an input's data come with those of another one of its name, as the mount of a sensor
/// does with what the sensor sees.
template <class Inputs>
bool comesWithAnother(const InputPort& input, const Inputs& inputs) {
  return input.time == TimeRole::kLatched &&
         std::any_of(inputs.begin(), inputs.end(), [&](const InputPort& other) {
           return other.name == input.name && other.time != TimeRole::kLatched;
         });
}

}  // namespace slam
