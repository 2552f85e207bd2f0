// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "slam_core/contract/ports.hpp"

namespace slam {

/// The ports of all components and gates that are wired, seen as one: what the whole takes in and
/// makes.
class WiredPorts {
 public:
  /// @param title what sentences call the component: "back-end 'ekf'"
  /// @return its ports, which stay in their place
  const Ports& add(const std::string& title, Ports ports);

  /// The inputs in their order; of the same name and kind one, mandatory where it is so for anyone.
  std::vector<InputPort> inputs() const;
  /// Those of them that nobody makes.
  std::vector<InputPort> open() const;
  std::vector<OutputPort> outputs() const;
  /// Titles of those that take in an input: "the back-end 'ekf' and ...".
  std::string takersOf(const std::string& port, Kind kind) const;
  /// @throw ConfigError where two make the same output
  void requireOneMakerEach() const;

 private:
  struct Part {
    std::string title;
    Ports ports;
  };

  /// Refuses a part that makes what one before it makes.
  void requireOneMaker(const Part& part) const;
  bool isMade(const std::string& port, Kind kind) const;

  std::deque<Part> parts_;  // a deque: ports are referred to
};

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
