// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "slam_core/contract/data.hpp"

namespace slam {

/// What the data of an input do to time.
enum class TimeRole {
  kTrigger,  ///< each causes a step at its stamp
  kCarrier,  ///< carries time forward between the triggers: motion
  kLatched,  ///< in force for all that follows, whatever its stamp: a calibration, a mount
};

/// An input of a component. Name and kind together determine what it is connected with.
struct InputPort {
  std::string name;      ///< "scan", as topics and messages call it
  Kind kind;             ///< of its data
  std::string sentence;  ///< what comes in there, for messages: "laser scans"
  TimeRole time = TimeRole::kTrigger;
  bool is_mandatory = true;
  KindTraits traits;
  std::function<void(const void*)> set;  ///< gives the component a value of the kind

  InputPort& optional() { return is_mandatory = false, *this; }
  InputPort& carrier() { return time = TimeRole::kCarrier, *this; }
  InputPort& latched() { return time = TimeRole::kLatched, *this; }
};

/// An output of a component.
struct OutputPort {
  std::string name;
  Kind kind;
  std::function<const void*()> get;  ///< of the last execute(); null if it made nothing
};

/// The first of some inputs or outputs that has this name and kind; null if none has.
template <class Range>
const typename Range::value_type* findPort(const Range& ports, const std::string& name, Kind kind) {
  const auto found = std::find_if(ports.begin(), ports.end(), [&](const auto& port) {
    return port.name == name && port.kind == kind;
  });
  return found == ports.end() ? nullptr : &*found;
}

/// The first of some parts of a product that makes data of this name and kind; null if none does.
template <class Parts>
const typename Parts::value_type* makerOf(const Parts& parts, const std::string& port, Kind kind) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const auto& part) { return part.makes(port, kind); });
  return found == parts.end() ? nullptr : &*found;
}

/// A component's inputs and outputs, each described once, by describe(). The wiring connects them;
/// they also determine what a product needs, what it subscribes to, and what a diagram shows.
class Ports {
 public:
  /// Adds an input whose values are passed to a function.
  template <class T, class Set>
  InputPort& takes(const std::string& name, const std::string& sentence, Set set) {
    auto give = [set = std::move(set)](const void* value) { set(*static_cast<const T*>(value)); };
    return inputs_.emplace_back(InputPort{name, kindOf<T>(), sentence, TimeRole::kTrigger, true,
                                          KindTraits::of<T>(), std::move(give)});
  }
  /// The same for a component with an overload set(const T&).
  template <class T, class Component>
  InputPort& takes(const std::string& name, const std::string& sentence, Component* component) {
    return takes<T>(name, sentence, [component](const T& value) { component->set(value); });
  }

  /// Adds an output that is an optional member: what the last execute() made, or nothing.
  template <class T>
  OutputPort& makes(const std::string& name, const std::optional<T>& value) {
    return makes<T>(name, [&value]() -> const T* { return value ? &*value : nullptr; });
  }
  /// Adds an output: `get` returns a pointer to what the last execute() made, or null.
  template <class T, class Get>
  OutputPort& makes(const std::string& name, Get get) {
    auto find = [get = std::move(get)]() -> const void* {
      const T* value = get();
      return value;
    };
    return outputs_.emplace_back(OutputPort{name, kindOf<T>(), std::move(find)});
  }

  /// Adds a port that another component has described.
  InputPort& add(InputPort port) { return inputs_.emplace_back(std::move(port)); }
  OutputPort& add(OutputPort port) { return outputs_.emplace_back(std::move(port)); }

  const std::deque<InputPort>& inputs() const& { return inputs_; }
  const std::deque<OutputPort>& outputs() const& { return outputs_; }
  /// These return by value, since a reference would outlive the temporary.
  std::deque<InputPort> inputs() && { return std::move(inputs_); }
  std::deque<OutputPort> outputs() && { return std::move(outputs_); }
  /// Null if there is none.
  const InputPort* input(const std::string& name, Kind kind) const {
    return findPort(inputs_, name, kind);
  }
  const OutputPort* output(const std::string& name, Kind kind) const {
    return findPort(outputs_, name, kind);
  }

 private:
  std::deque<InputPort> inputs_;  // deques: what is added is handed out by reference
  std::deque<OutputPort> outputs_;
};

}  // namespace slam
