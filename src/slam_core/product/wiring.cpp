// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/wiring.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"

namespace slam {

std::unique_ptr<Gate> gateFor(const InputPort& input) {
  const auto& registry = Registry<Gate>::instance();
  const auto kinds = registry.names();
  const auto kind = nameOf(input.kind);
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) return nullptr;
  auto gate = registry.create(kind);
  return portsOf(*gate).output(input.name, input.kind) == nullptr ? nullptr : std::move(gate);
}

void Wiring::add(const std::string& prefix, Component& component, Turn turn,
                 const std::string& title) {
  nodes_.push_back({prefix, &component, portsOf(component), turn, title});
}

void Wiring::connect(Settings& settings) {
  FaultCollector faults;
  for (auto& node : nodes_) faults.attempt([&] { requireOneMaker(node); });
  faults.attempt([&] { placeGates(settings); });
  faults.raise();
  for (auto& node : nodes_)
    for (const auto& input : node.ports.inputs())
      routes_[{input.name, input.kind}].consumers.push_back({&node, &input});
}

/// Refuses a node that makes what one before it makes.
void Wiring::requireOneMaker(const Node& node) const {
  for (const auto& output : node.ports.outputs())
    for (const auto& other : nodes_) {
      if (&other == &node) break;
      if (other.ports.output(output.name, output.kind) != nullptr)
        throw ConfigError("two components make '" + output.name + "' (" + nameOf(output.kind) +
                          "): the " + other.title + " and the " + node.title +
                          "; leave one of them out of the product");
    }
}

/// Before each input that nobody makes and that a gate is registered for.
void Wiring::placeGates(Settings& settings) {
  for (const auto& input : open()) {
    auto gate = gateFor(input);
    if (!gate) continue;
    gate->configure(settings);
    add(gate->name() + "_", *gate, Turn::kAtOnce, Gate::kRole + (" '" + gate->name() + "'"));
    gates_.push_back(std::move(gate));
  }
}

bool Wiring::isMade(const std::string& port, Kind kind) const {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [&](const Node& node) { return node.ports.output(port, kind) != nullptr; });
}

std::vector<InputPort> Wiring::inputs() const {
  std::vector<InputPort> all;
  for (const auto& node : nodes_)
    for (const auto& input : node.ports.inputs()) {
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

std::vector<InputPort> Wiring::open() const {
  auto inputs = this->inputs();
  inputs.erase(std::remove_if(inputs.begin(), inputs.end(),
                              [this](const auto& input) { return isMade(input.name, input.kind); }),
               inputs.end());
  return inputs;
}

std::vector<OutputPort> Wiring::outputs() const {
  std::vector<OutputPort> all;
  for (const auto& node : nodes_)
    all.insert(all.end(), node.ports.outputs().begin(), node.ports.outputs().end());
  return all;
}

std::string Wiring::takersOf(const std::string& port, Kind kind) const {
  std::vector<std::string> titles;
  for (const auto& node : nodes_)
    if (node.ports.input(port, kind) != nullptr) titles.push_back("the " + node.title);
  return join(titles, " and ");
}

const void* Wiring::completed(Kind kind, const void* value, std::shared_ptr<void>& copy) const {
  const auto completion = completions_.find(kind);
  if (completion == completions_.end()) return value;
  copy = completion->second(value);
  return copy.get();
}

void Wiring::put(const std::string& port, Kind kind, const void* value) {
  const auto route = routes_.find({port, kind});
  if (route == routes_.end()) return;
  std::shared_ptr<void> copy;
  pass(route->second, completed(kind, value, copy));
}

void Wiring::pass(const Route& route, const void* value) {
  for (const auto& [node, input] : route.consumers) {
    input->set(value);
    if (node->turn == Turn::kAtOnce) run(*node);
  }
}

void Wiring::listen(const std::string& port, Kind kind, Listener listener) {
  routes_[{port, kind}].listeners.push_back(std::move(listener));
}

void Wiring::run(Node& node) {
  do {
    const auto status = node.component->execute();
    if (!status.isOk()) status_ = status;
    handOn(node);
  } while (node.component->isBusy());
}

void Wiring::handOn(Node& node) {
  for (const auto& output : node.ports.outputs()) {
    const auto* value = output.get();
    const auto route = routes_.find({output.name, output.kind});
    if (value == nullptr || route == routes_.end()) continue;
    std::shared_ptr<void> copy;
    value = completed(output.kind, value, copy);
    pass(route->second, value);
    for (const auto& listener : route->second.listeners) listener(value);
  }
}

Status Wiring::step() {
  Status status;
  for (auto& node : nodes_) {
    if (node.turn != Turn::kOnRequest) continue;
    status = node.component->execute();
    handOn(node);
  }
  return status;
}

Counters Wiring::counters() const {
  Counters all;
  for (const auto& node : nodes_) all.add(node.component->counters(), node.prefix);
  return all;
}

Component::Figures Wiring::figures() const {
  Component::Figures all;
  for (const auto& node : nodes_) {
    const auto figures = node.component->figures();
    all.insert(all.end(), figures.begin(), figures.end());
  }
  return all;
}

Counters Wiring::held() const {
  Counters all;
  for (const auto& gate : gates_) all.add(gate->held(), gate->name() + "_");
  return all;
}

void Wiring::reset() {
  for (auto& node : nodes_) node.component->reset();
  status_ = Status::ok();
}

}  // namespace slam
