// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/part_inputs.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/input_bindings.hpp"

namespace slam_ros {

PartInputs::PartInputs(const InputContext& context, const slam::Wiring& wiring,
                       const slam::Ports& also) {
  slam::FaultCollector faults;
  const auto open = wiring.ports().open();
  for (const auto& port : open)
    if (!slam::comesWithAnother(port, open)) faults.attempt([&] { bind(context, port); });
  faults.raise();
  const auto& all = InputBindings::instance();
  for (const auto& port : also.inputs())
    if (!takes(port.name) && all.has(port.kind)) bindings_[port.name] = all.create(context, port);
}

void PartInputs::bind(const InputContext& context, const slam::InputPort& port) {
  bindings_[port.name] = InputBindings::instance().create(context, port);
  if (port.is_mandatory) mandatory_.push_back(port.name);
}

std::string PartInputs::waiting(const std::vector<std::string>& needless) const {
  for (const auto& input : mandatory_) {
    if (std::count(needless.begin(), needless.end(), input) > 0) continue;
    if (const auto waiting = of(input).waiting(); !waiting.empty()) return waiting;
  }
  return "";
}

}  // namespace slam_ros
