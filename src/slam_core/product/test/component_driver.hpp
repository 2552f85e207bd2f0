// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "slam_core/contract/component.hpp"

namespace slam::test {

/// Gives a component its inputs by its ports, as the wiring of a product does.
class ComponentDriver {
 public:
  /// @param component outlives this and stays in its place
  explicit ComponentDriver(Component& component) : ports_(portsOf(component)) {}

  const Ports& ports() const { return ports_; }

  /// Whether an input takes data of this kind.
  template <class T>
  bool takes() const {
    return count(kindOf<T>()) > 0;
  }
  /// A value for the only input of its kind.
  /// @throw std::logic_error where no input takes this kind, or several do
  template <class T>
  void set(const T& value) {
    inputOf(kindOf<T>()).set(&value);
  }
  /// The same where an input takes this kind; else nothing comes of it.
  template <class T>
  void offer(const T& value) {
    if (takes<T>()) set(value);
  }

 private:
  std::ptrdiff_t count(Kind kind) const {
    const auto& inputs = ports_.inputs();
    return std::count_if(inputs.begin(), inputs.end(),
                         [&](const InputPort& input) { return input.kind == kind; });
  }
  const InputPort& inputOf(Kind kind) const {
    if (count(kind) != 1)
      throw std::logic_error(std::to_string(count(kind)) + " inputs take " + nameOf(kind));
    const auto& inputs = ports_.inputs();
    return *std::find_if(inputs.begin(), inputs.end(),
                         [&](const InputPort& input) { return input.kind == kind; });
  }

  Ports ports_;
};

/// The figure of this name. @throw std::out_of_range where the component tells none
inline double figureOf(const Component& component, const std::string& name) {
  for (const auto& [other, value] : component.figures())
    if (other == name) return value;
  throw std::out_of_range("there is no figure '" + name + "'");
}

}  // namespace slam::test
