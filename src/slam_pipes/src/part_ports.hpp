// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/product/product_components.hpp"

namespace slam_pipes {

/// A component that gets a process of its own, with the input gates before it: what it takes in by
/// pipes and what it makes. Which pipes there are follows from this alone, in the program that
/// starts the processes as in each of them.
struct PartPorts {
  slam::ProductPart part;
  std::string key;    ///< "odometry", "rear_detector", "backend", the name of a module
  std::string title;  ///< "odometry source 'wheel'", for sentences
  std::vector<slam::InputPort> inputs;
  std::vector<slam::OutputPort> outputs;
  slam::ProductComponents components;  ///< not configured; the ports hold pointers to them
  slam::WiredPorts wired;              ///< with the gates, which the ports hold pointers to as well

  bool isBackend() const { return part.extent == slam::ProductPart::Extent::kBackend; }
  /// Null where it takes no such data. @param kind its name
  const slam::InputPort* input(const std::string& port, const std::string& kind) const;
  /// @return those inputs of another part whose data this one makes
  std::vector<slam::InputPort> inputsOf(const PartPorts& taker) const;
};

/// The components that a product names, in the order of the data's flow.
/// @throw slam::ConfigError naming the components that there are
std::vector<PartPorts> partsOf(const slam::ProductConfig& product);

/// Null where there is none.
const PartPorts* findPart(const std::vector<PartPorts>& parts, const std::string& key);

/// Refuses an input whose data cannot be written. @throw slam::ConfigError
void requirePersistent(const slam::InputPort& input, const PartPorts& taker);

}  // namespace slam_pipes
