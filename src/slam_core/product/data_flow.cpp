// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/data_flow.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "slam_core/product/wired_ports.hpp"

namespace slam {
namespace {

bool isTrigger(const InputPort& input) { return input.time == TimeRole::kTrigger; }

bool isMadeBy(const std::vector<ProductComponent>& components, const InputPort& input) {
  return std::any_of(components.begin(), components.end(), [&](const auto& other) {
    return portsOf(*other.component).output(input.name, input.kind) != nullptr;
  });
}

void addInputs(const Ports& ports, const std::vector<ProductComponent>& components,
               std::vector<InputPort>& inputs) {
  for (const auto& input : ports.inputs()) {
    if (comesWithAnother(input, ports.inputs())) continue;
    const auto gate = isMadeBy(components, input) ? nullptr : gateFor(input);
    if (gate)
      addInputs(portsOf(*gate), components, inputs);
    else
      inputs.push_back(input);
  }
}

}  // namespace

const InputPort* DataFlow::Part::input(const std::string& name, Kind kind) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const auto& port) {
    return port.name == name && port.kind == kind;
  });
  return found == inputs.end() ? nullptr : &*found;
}

bool DataFlow::Part::makes(const std::string& output, Kind kind) const {
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const auto& port) { return port.name == output && port.kind == kind; });
}

DataFlow::DataFlow(const ProductComponents& product) {
  const auto components = inOrder(product);
  for (const auto& component : components) {
    const auto ports = portsOf(*component.component);
    Part part{component.role, component.key, {}, {}, false, false};
    addInputs(ports, components, part.inputs);
    part.outputs.assign(ports.outputs().begin(), ports.outputs().end());
    part.is_backend = component.component == product.estimator.get();
    part.is_maker = !part.is_backend && component.role != MapModule::kRole;
    for (auto& input : part.inputs) input.set = nullptr;
    for (auto& output : part.outputs) output.get = nullptr;
    parts_.push_back(std::move(part));
  }
}

bool DataFlow::isMade(const InputPort& input) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.makes(input.name, input.kind); });
}

std::vector<InputPort> DataFlow::triggersOfBackend() const {
  std::vector<InputPort> triggers;
  for (const auto& part : parts_)
    if (part.is_backend)
      std::copy_if(part.inputs.begin(), part.inputs.end(), std::back_inserter(triggers), isTrigger);
  return triggers;
}

bool DataFlow::leadsToSteps(const std::string& input, Kind kind) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    const auto* port = part.input(input, kind);
    if (port == nullptr) return false;
    return part.is_maker ? triggersSteps(part) : isTrigger(*port);
  });
}

std::vector<OutputPort> DataFlow::takenOutputs(const Part& part) const {
  std::vector<OutputPort> outputs;
  for (const auto& output : part.outputs)
    if (!takersOf(output).empty()) outputs.push_back(output);
  return outputs;
}

bool DataFlow::triggersSteps(const Part& part) const {
  return std::any_of(part.outputs.begin(), part.outputs.end(), [&](const auto& output) {
    const auto takers = takersOf(output);
    return std::any_of(takers.begin(), takers.end(), isTrigger);
  });
}

std::vector<InputPort> DataFlow::inputsOfAlone(const Part& part) const {
  std::vector<InputPort> inputs;
  for (const auto& input : part.inputs) {
    const auto takers = std::count_if(parts_.begin(), parts_.end(), [&](const Part& other) {
      return other.input(input.name, input.kind) != nullptr;
    });
    if (takers == 1 && !isMade(input)) inputs.push_back(input);
  }
  return inputs;
}

std::vector<InputPort> DataFlow::takersOf(const OutputPort& output) const {
  std::vector<InputPort> takers;
  for (const auto& part : parts_)
    if (const auto* input = part.input(output.name, output.kind)) takers.push_back(*input);
  return takers;
}

}  // namespace slam
