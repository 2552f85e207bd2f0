// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/product/product_components.hpp"

namespace slam {

/// Who makes the data of a product and who takes them, by the ports of its components alone.
class DataFlow {
 public:
  struct Part {
    std::string role, key;  ///< as of ProductComponent
    /// The component's inputs; where a gate stands before one, the gate's inputs in its place.
    /// Latched inputs that come with the data of the same port are left out.
    std::vector<InputPort> inputs;
    std::vector<OutputPort> outputs;
    bool is_maker = false;  ///< what it makes can take its place: neither back-end nor module
    bool is_backend = false;
    bool isModule() const { return !is_maker && !is_backend; }

    /// Null where it takes no such data.
    const InputPort* input(const std::string& name, Kind kind) const {
      return findPort(inputs, name, kind);
    }
    bool makes(const std::string& output, Kind kind) const {
      return findPort(outputs, output, kind) != nullptr;
    }
    /// "odometry component", "detector"
    std::string title() const { return role == key ? role : key + " component"; }
  };

  /// @param product is not referred to afterwards
  explicit DataFlow(const ProductComponents& product);

  /// In the order of the data's flow.
  const std::vector<Part>& parts() const { return parts_; }
  /// Whether a component makes the input's data.
  bool isMade(const InputPort& input) const;
  /// The inputs that steps are taken for, those that components make included.
  std::vector<InputPort> triggersOfBackend() const;
  /// Whether steps are taken for data that come in there, or for what is made of them.
  bool leadsToSteps(const std::string& input, Kind kind) const;
  /// The inputs of a part that no other one takes and none makes.
  std::vector<InputPort> inputsOfAlone(const Part& part) const;
  /// What others take of what a part makes.
  std::vector<OutputPort> takenOutputs(const Part& part) const;
  /// Follows a part's data to their end. The result contains the part's outputs that a back-end or
  /// a module takes, and the last outputs of those makers for which the part's outputs are
  /// triggers.
  std::vector<OutputPort> lastOutputs(const Part& part) const;
  /// Whether steps are taken for what a part makes.
  bool triggersSteps(const Part& part) const;
  /// The inputs that take in an output.
  std::vector<InputPort> takersOf(const OutputPort& output) const;

 private:
  std::vector<Part> parts_;
};

}  // namespace slam
