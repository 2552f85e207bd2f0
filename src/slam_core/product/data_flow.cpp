// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/data_flow.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace slam {
namespace {

bool isTrigger(const InputPort& input) { return input.time == TimeRole::kTrigger; }

/// @param passed gates that the way has led through: each is described once, and no circle of gates
/// is followed for ever
void addInputs(const Ports& ports, const WiredPorts& wired, std::vector<const Gate*>& passed,
               std::vector<InputPort>& inputs) {
  for (const auto& input : ports.inputs()) {
    if (comesWithAnother(input, ports.inputs())) continue;
    const auto* maker = wired.makerOf(input);
    if (maker == nullptr || maker->gate == nullptr) {
      if (findPort(inputs, input.name, input.kind) == nullptr) inputs.push_back(input);
    } else if (std::count(passed.begin(), passed.end(), maker->gate) == 0) {
      passed.push_back(maker->gate);
      addInputs(maker->ports, wired, passed, inputs);
    }
  }
}

std::vector<InputPort> inputsBeforeGates(const Ports& ports, const WiredPorts& wired) {
  std::vector<const Gate*> passed;
  std::vector<InputPort> inputs;
  addInputs(ports, wired, passed, inputs);
  for (auto& input : inputs) input.set = nullptr;
  return inputs;
}

}  // namespace

DataFlow::DataFlow(const ProductComponents& product) {
  const auto wired = wiredPortsOf(product);
  for (const auto& component : inOrder(product)) {
    const auto ports = portsOf(component);
    Part part{component.role, component.key, inputsBeforeGates(ports, wired), {}, false, false};
    part.outputs.assign(ports.outputs().begin(), ports.outputs().end());
    part.is_backend = component.component == product.estimator.get();
    part.is_maker = !part.is_backend && component.role != MapModule::kRole;
    for (auto& output : part.outputs) output.get = nullptr;
    parts_.push_back(std::move(part));
  }
}

bool DataFlow::isMade(const InputPort& input) const {
  return makerOf(parts_, input.name, input.kind) != nullptr;
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

std::vector<OutputPort> DataFlow::lastOutputs(const Part& part) const {
  std::vector<OutputPort> last;
  for (const auto& output : part.outputs) {
    bool is_last = takersOf(output).empty();
    for (const auto& taker : parts_) {
      const auto* input = taker.input(output.name, output.kind);
      if (input == nullptr) continue;
      is_last = is_last || !taker.is_maker;
      if (!taker.is_maker || !isTrigger(*input)) continue;
      const auto further = lastOutputs(taker);
      last.insert(last.end(), further.begin(), further.end());
    }
    if (is_last) last.push_back(output);
  }
  return last;
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
