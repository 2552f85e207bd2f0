// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "part_ports.hpp"

#include <algorithm>

namespace slam_pipes {
namespace {

using Extent = slam::ProductPart::Extent;

slam::ProductPart partOf(const slam::ProductComponent& component,
                         const slam::ProductComponents& whole) {
  if (component.key == "odometry") return {Extent::kOdometry, ""};
  if (component.key == "backend") return {Extent::kBackend, ""};
  for (const auto& stage : whole.stages)
    if (stage.component.get() == component.component) return {Extent::kStage, component.name};
  for (const auto& detector : whole.detectors)
    if (detector.component.get() == component.component)
      return {Extent::kDetector, "", detector.place.prefix()};
  return {Extent::kModule, component.name};
}

}  // namespace

const slam::InputPort* PartPorts::input(const std::string& port, const std::string& kind) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const slam::InputPort& input) {
    return input.name == port && slam::nameOf(input.kind) == kind;
  });
  return found == inputs.end() ? nullptr : &*found;
}

std::vector<slam::InputPort> PartPorts::inputsOf(const PartPorts& taker) const {
  std::vector<slam::InputPort> taken;
  for (const auto& output : outputs)
    if (const auto* input = slam::findPort(taker.inputs, output.name, output.kind))
      taken.push_back(*input);
  return taken;
}

std::vector<PartPorts> partsOf(const slam::ProductConfig& product) {
  std::vector<PartPorts> parts;
  const auto whole = createComponents(product);
  for (const auto& component : inOrder(whole)) {
    PartPorts part;
    part.part = partOf(component, whole);
    part.key = component.key;
    part.title = component.title();
    part.components = createComponents(product, part.part);
    part.wired = wiredPortsOf(part.components);
    part.inputs = part.wired.open();
    const auto& own = part.wired.parts().front().ports.outputs();
    part.outputs.assign(own.begin(), own.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

const PartPorts* findPart(const std::vector<PartPorts>& parts, const std::string& key) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const PartPorts& part) { return part.key == key; });
  return found == parts.end() ? nullptr : &*found;
}

void requirePersistent(const slam::InputPort& input, const PartPorts& taker) {
  if (input.traits.save != nullptr) return;
  throw slam::ConfigError("'" + input.name + "' (" + slam::nameOf(input.kind) + "), which the " +
                          taker.title +
                          " takes in, cannot cross a pipe: give the type a persist(), or run the "
                          "product without --middleware pipes");
}

}  // namespace slam_pipes
