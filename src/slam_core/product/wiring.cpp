// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/wiring.hpp"

#include <utility>

#include "slam_core/common/config_error.hpp"

namespace slam {

void Wiring::add(const std::string& prefix, Component& component, Turn turn,
                 const std::string& title, Ports ports) {
  nodes_.push_back({prefix, &component, &ports_.add(title, component, std::move(ports)), turn});
}

void Wiring::connect(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] { ports_.placeGates(); });
  faults.attempt([&] { ports_.requireJoinable(); });
  faults.attempt([&] { configureGates(settings); });
  faults.raise();
  for (auto& node : nodes_)
    for (const auto& input : node.ports->inputs())
      routes_[{input.name, input.kind}].consumers.push_back({&node, &input});
}

/// Configures the gates; each executes with every value that comes in.
void Wiring::configureGates(Settings& settings) {
  FaultCollector faults;
  for (const auto& part : ports_.parts()) {
    if (part.gate == nullptr) continue;
    faults.attempt([&] { part.gate->configure(settings); });
    nodes_.push_back({part.gate->name() + "_", part.gate, &part.ports, Turn::kAtOnce});
  }
  faults.raise();
}

void Wiring::put(const std::string& port, Kind kind, const void* value) {
  const auto route = routes_.find({port, kind});
  if (route == routes_.end()) return;
  std::shared_ptr<void> copy;
  pass(route->second, completions_.complete(kind, value, copy));
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
  for (const auto& output : node.ports->outputs()) {
    const auto* value = output.get();
    const auto route = routes_.find({output.name, output.kind});
    if (value == nullptr || route == routes_.end()) continue;
    std::shared_ptr<void> copy;
    value = completions_.complete(output.kind, value, copy);
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
  return moreUrgent(status, std::exchange(status_, Status::ok()));
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

std::string notResumable(const Wiring& wiring) {
  for (const auto& part : wiring.ports().parts())
    if (!part.component->canResume()) return part.title;
  return "";
}

Counters heldAtGates(const Wiring& wiring) {
  Counters all;
  for (const auto& gate : wiring.gates()) all.add(gate->held(), gate->name() + "_");
  return all;
}

void Wiring::reset() {
  for (auto& node : nodes_) node.component->reset();
  status_ = Status::ok();
}

}  // namespace slam
