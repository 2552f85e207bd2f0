// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/product/wiring.hpp"
#include "slam_ros/input_binding.hpp"

namespace slam_ros {

/// Subscribes to all inputs of a part of a product, by its ports.
class PartInputs {
 public:
  PartInputs() = default;
  /// @param wiring connected; its open inputs are subscribed to. So are the inputs of `also` that a
  /// message can bring, although a component makes them, since other nodes may publish them
  /// @throw slam::ConfigError if no binding brings an input, ros::InvalidNameException
  PartInputs(const InputContext& context, const slam::Wiring& wiring, const slam::Ports& also = {});

  /// Adds one more input. It replaces a binding of this name and kind.
  void add(const slam::InputPort& port, std::unique_ptr<InputBinding> binding);

  /// Whether data of this kind come to the input on a topic of their own.
  bool takes(const std::string& input, slam::Kind kind) const {
    return bindings_.count({input, kind}) > 0;
  }
  /// The binding that brings data of this kind to the input; a mount comes with the sensor's data.
  const InputBinding& of(const std::string& input, slam::Kind kind) const;
  /// What the first mandatory input waits for; empty if all have come.
  /// @param needless inputs from which nothing is expected, since the data that are made of them
  /// come from elsewhere
  std::string waiting(const std::vector<slam::InputPort>& needless = {}) const;
  /// Whether all that other components make for the inputs is published.
  bool areConnected() const;
  /// From here on no callback runs.
  void stop() {
    bindings_.clear();
    mandatory_.clear();
  }

 private:
  using Address = std::pair<std::string, slam::Kind>;

  bool takesAny(const std::string& input) const;

  std::map<Address, std::unique_ptr<InputBinding>> bindings_;  ///< by input
  std::vector<Address> mandatory_;                             ///< inputs, in their order
};

}  // namespace slam_ros
