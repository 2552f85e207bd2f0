// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/wired_ports.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "slam_core/common/config_error.hpp"

namespace slam {
namespace {

/// Goes from those who take data to those who make them, and refuses to come back.
class CycleSearch {
 public:
  explicit CycleSearch(const WiredPorts& ports) : ports_(ports) {}

  void visit(const WiredPorts::Part& part) {
    const auto begin = std::find_if(way_.begin(), way_.end(),
                                    [&](const Step& step) { return step.taker == &part; });
    if (begin != way_.end()) throw ConfigError(sentence({begin, way_.end()}));
    if (!visited_.insert(&part).second) return;
    for (const auto& input : part.ports.inputs()) {
      const auto* maker = ports_.makerOf(input);
      if (maker == nullptr) continue;
      way_.push_back({&part, &input, maker});
      visit(*maker);
      way_.pop_back();
    }
  }

 private:
  struct Step {
    const WiredPorts::Part* taker;
    const InputPort* input;
    const WiredPorts::Part* maker;
  };

  static std::string sentence(const std::vector<Step>& circle) {
    std::vector<std::string> steps;
    for (const auto& [taker, input, maker] : circle)
      steps.push_back("the " + taker->title + " takes '" + input->name + "' (" +
                      nameOf(input->kind) + ") from " +
                      (maker == taker ? "itself" : "the " + maker->title));
    return "components cannot take data from one another in a circle: " + join(steps) +
           "; leave one of them out of the product, or give one of the ports another name";
  }

  const WiredPorts& ports_;
  std::vector<Step> way_;
  std::set<const WiredPorts::Part*> visited_;  // is only asked, so that its order does not matter
};

}  // namespace

const Ports& WiredPorts::add(const std::string& title, const Component& component, Ports ports) {
  parts_.push_back({title, &component, std::move(ports)});
  return parts_.back().ports;
}

void WiredPorts::placeGates() {
  const auto next = [this]() -> std::unique_ptr<Gate> {
    for (const auto& input : open())
      if (auto gate = createMakerOf<Gate>(input)) return gate;
    return nullptr;
  };
  while (auto gate = next()) {
    add(Gate::kRole + (" '" + gate->name() + "'"), *gate);
    parts_.back().gate = gate.get();
    gates_.push_back(std::move(gate));
  }
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
                           [this](const auto& input) { return makerOf(input) != nullptr; }),
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

void WiredPorts::requireJoinable() const {
  FaultCollector faults;
  for (const auto& part : parts_) faults.attempt([&] { requireOneMaker(part); });
  faults.attempt([&] {
    CycleSearch search(*this);
    for (const auto& part : parts_) search.visit(part);
  });
  faults.raise();
}

void WiredPorts::requireOneMaker(const Part& part) const {
  for (const auto& output : part.ports.outputs())
    for (const auto& other : parts_) {
      if (&other == &part) break;
      if (other.makes(output.name, output.kind))
        throw ConfigError("two components make '" + output.name + "' (" + nameOf(output.kind) +
                          "): the " + other.title + " and the " + part.title +
                          "; leave one of them out of the product");
    }
}

}  // namespace slam
