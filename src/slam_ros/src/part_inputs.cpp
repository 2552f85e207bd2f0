// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/part_inputs.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/input_bindings.hpp"

namespace slam_ros {

PartInputs::PartInputs(const InputContext& context, const slam::Wiring& wiring,
                       const slam::Ports& also) {
  const auto& all = InputBindings::instance();
  slam::FaultCollector faults;
  const auto open = wiring.ports().open();
  for (const auto& port : open)
    if (!slam::comesWithAnother(port, open))
      faults.attempt([&] { add(port, all.create(context, port)); });
  faults.raise();
  // they may come, but are not waited for; a topic has messages of one type only
  for (auto port : also.inputs()) {
    if (takesAny(port.name) || !all.has(port.kind)) continue;
    auto binding = all.create(context, port);
    add(port.optional(), std::move(binding));
  }
}

void PartInputs::add(const slam::InputPort& port, std::unique_ptr<InputBinding> binding) {
  bindings_[{port.name, port.kind}] = std::move(binding);
  if (port.is_mandatory) mandatory_.emplace_back(port.name, port.kind);
}

bool PartInputs::takesAny(const std::string& input) const {
  return std::any_of(bindings_.begin(), bindings_.end(),
                     [&](const auto& entry) { return entry.first.first == input; });
}

const InputBinding& PartInputs::of(const std::string& input, slam::Kind kind) const {
  if (const auto own = bindings_.find({input, kind}); own != bindings_.end()) return *own->second;
  const auto other = std::find_if(bindings_.begin(), bindings_.end(),
                                  [&](const auto& entry) { return entry.first.first == input; });
  if (other == bindings_.end()) throw std::out_of_range("nothing brings data to '" + input + "'");
  return *other->second;
}

bool PartInputs::areConnected() const {
  return std::all_of(bindings_.begin(), bindings_.end(),
                     [](const auto& entry) { return entry.second->isConnected(); });
}

std::string PartInputs::waiting(const std::vector<slam::InputPort>& needless) const {
  for (const auto& address : mandatory_) {
    if (slam::findPort(needless, address.first, address.second) != nullptr) continue;
    if (const auto waiting = bindings_.at(address)->waiting(); !waiting.empty()) return waiting;
  }
  return "";
}

}  // namespace slam_ros
