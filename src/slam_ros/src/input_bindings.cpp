// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/input_bindings.hpp"

#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/sorted_unique.hpp"

namespace slam_ros {

InputBindings& InputBindings::instance() {
  static InputBindings bindings;
  return bindings;
}

std::vector<std::string> InputBindings::kinds() const {
  std::vector<std::string> kinds;
  for (const auto& entry : bindings_) kinds.push_back(slam::nameOf(entry.first));
  return slam::sortedUnique(std::move(kinds));
}

std::unique_ptr<InputBinding> InputBindings::create(const InputContext& context,
                                                    const slam::InputPort& port) const {
  return of(port.name, port.kind).live(context, port);
}

std::unique_ptr<BagInput> InputBindings::createInBag(const BagContext& context,
                                                     const std::string& port,
                                                     slam::Kind kind) const {
  return of(port, kind).in_bag(context, port);
}

const InputBindings::Binding& InputBindings::of(const std::string& port, slam::Kind kind) const {
  const auto count = bindings_.count(kind);
  if (count == 1) return bindings_.find(kind)->second;
  const auto input = "the input '" + port + "' (" + slam::nameOf(kind) + ")";
  if (count > 1)
    throw slam::ConfigError(std::to_string(count) + " bindings bring data for " + input +
                            "; leave all but one of their libraries out of the product");
  throw slam::ConfigError("nobody makes data for " + input +
                          ", and no binding brings them from a topic; there are bindings for " +
                          slam::join(kinds()) +
                          ": name the library that has one in the product's `libraries`");
}

}  // namespace slam_ros
