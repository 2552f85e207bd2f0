// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/wired_ports.hpp"

#include <algorithm>
#include <utility>

#include "slam_core/common/config_error.hpp"

namespace slam {

const Ports& WiredPorts::add(const std::string& title, Ports ports) {
  parts_.push_back({title, std::move(ports)});
  return parts_.back().ports;
}

std::vector<InputPort> WiredPorts::inputs() const {
  std::vector<InputPort> all;
  for (const auto& part : parts_)
    for (const auto& input : part.ports.inputs()) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const InputPort& other) {
        return other.name == input.name && other.kind == input.kind;
      });
      if (same == all.end())
        all.push_back(input);
      else
        same->is_mandatory = same->is_mandatory || input.is_mandatory;
    }
  return all;
}

std::vector<InputPort> WiredPorts::open() const {
  auto all = inputs();
  all.erase(std::remove_if(all.begin(), all.end(),
                           [this](const auto& input) { return isMade(input.name, input.kind); }),
            all.end());
  return all;
}

std::vector<OutputPort> WiredPorts::outputs() const {
  std::vector<OutputPort> all;
  for (const auto& part : parts_)
    all.insert(all.end(), part.ports.outputs().begin(), part.ports.outputs().end());
  return all;
}

std::string WiredPorts::takersOf(const std::string& port, Kind kind) const {
  std::vector<std::string> titles;
  for (const auto& part : parts_)
    if (part.ports.input(port, kind) != nullptr) titles.push_back("the " + part.title);
  return join(titles, " and ");
}

void WiredPorts::requireOneMakerEach() const {
  FaultCollector faults;
  for (const auto& part : parts_) faults.attempt([&] { requireOneMaker(part); });
  faults.raise();
}

void WiredPorts::requireOneMaker(const Part& part) const {
  for (const auto& output : part.ports.outputs())
    for (const auto& other : parts_) {
      if (&other == &part) break;
      if (other.ports.output(output.name, output.kind) != nullptr)
        throw ConfigError("two components make '" + output.name + "' (" + nameOf(output.kind) +
                          "): the " + other.title + " and the " + part.title +
                          "; leave one of them out of the product");
    }
}

bool WiredPorts::isMade(const std::string& port, Kind kind) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.ports.output(port, kind) != nullptr; });
}

}  // namespace slam
