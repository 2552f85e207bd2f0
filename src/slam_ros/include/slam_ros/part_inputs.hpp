// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/product/wiring.hpp"
#include "slam_ros/input_binding.hpp"

namespace slam_ros {

/// Subscribes all that a part of a product takes in, by its ports.
class PartInputs {
 public:
  /// @param wiring connected; its open inputs are subscribed, and those of `also` that a message
  /// can bring although a component makes them: other nodes may do so
  /// @throw slam::ConfigError where no binding brings an input, ros::InvalidNameException
  PartInputs(const InputContext& context, const slam::Wiring& wiring, const slam::Ports& also = {});

  bool takes(const std::string& input) const { return bindings_.count(input) > 0; }
  /// Of the input.
  const InputBinding& of(const std::string& input) const { return *bindings_.at(input); }
  /// What the first of them waits for that the part cannot do without; empty: all have come.
  /// @param needless inputs of which nothing is expected: what is made of them comes from elsewhere
  std::string waiting(const std::vector<std::string>& needless = {}) const;
  /// From here on no callback runs.
  void stop() {
    bindings_.clear();
    mandatory_.clear();
  }

 private:
  void bind(const InputContext& context, const slam::InputPort& port);

  std::map<std::string, std::unique_ptr<InputBinding>> bindings_;  ///< by input
  std::vector<std::string> mandatory_;                             ///< inputs, in their order
};

}  // namespace slam_ros
