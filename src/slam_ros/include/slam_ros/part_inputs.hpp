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

/// Subscribes all that a part of a product takes in, by its ports.
class PartInputs {
 public:
  PartInputs() = default;
  /// @param wiring connected; its open inputs are subscribed, and those of `also` that a message
  /// can bring although a component makes them: other nodes may do so
  /// @throw slam::ConfigError where no binding brings an input, ros::InvalidNameException
  PartInputs(const InputContext& context, const slam::Wiring& wiring, const slam::Ports& also = {});

  /// Takes one more input in, besides those there are; it replaces a binding of this name and kind.
  void add(const slam::InputPort& port, std::unique_ptr<InputBinding> binding);

  /// Whether data of this kind come to the input on a topic of their own.
  bool takes(const std::string& input, slam::Kind kind) const {
    return bindings_.count({input, kind}) > 0;
  }
  /// What brings data of this kind to the input: a mount comes with what the sensor sees.
  const InputBinding& of(const std::string& input, slam::Kind kind) const;
  /// What the first of them waits for that the part cannot do without; empty: all have come.
  /// @param needless inputs of which nothing is expected: what is made of them comes from elsewhere
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
