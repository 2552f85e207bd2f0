// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/product/data_flow.hpp"
#include "slam_ros/bag_input.hpp"
#include "slam_ros/bag_reader.hpp"

namespace slam_ros {

/// The inputs of a product that a bag has, by the ports of the product's components.
///
/// If the bag holds the output of a component, this output replaces the component, unless the bag
/// has an input of the component that others take as well, or a remapping asks for an input of the
/// component. If the bag also has the inputs of the component, its output is used only from a topic
/// of the output's own name or from a remapped one: a topic of the same type may be that of another
/// robot.
class BagInputs {
 public:
  /// @throw TopicError if an input that the product needs is missing (the message says what the bag
  /// has) or is ambiguous, and for a remapping that is wrong or would have no effect;
  /// slam::ConfigError
  BagInputs(const BagReader& bag, const slam::ProductComponents& product, const BagContext& context,
            const std::vector<Remap>& remaps);

  struct Found {
    std::string port;
    slam::Kind kind;
    std::unique_ptr<BagInput> input;
  };
  const std::vector<Found>& found() const { return found_; }
  /// The topics of the bag on which an input was found, that of its data first; none if it was not
  /// found.
  std::vector<std::string> topicsOf(const std::string& port) const;

  const slam::DataFlow& flow() const { return flow_; }
  /// The components that are not left out.
  std::vector<slam::DataFlow::Part> parts() const;
  bool isLeftOut(const std::string& key) const;
  /// Whether the bag has the data, or all inputs of the component that makes them.
  bool isSupplied(const slam::InputPort& input) const;

  /// Handlers for BagReader::read() that give the data of each input's messages to its sinks.
  /// @param sinksOf called with the Found of each input
  template <class SinksOf>
  BagHandlers readers(SinksOf sinksOf) const {
    BagHandlers handlers;
    for (const auto& found : found_) add(found.input->readers(sinksOf(found)), handlers);
    return handlers;
  }
  /// Handlers that publish the messages of each input.
  /// @param gateOf called with the Found of each input
  template <class GateOf>
  BagHandlers senders(const ros::NodeHandle& handle, GateOf gateOf) const {
    BagHandlers handlers;
    for (const auto& found : found_) add(found.input->senders(handle, gateOf(found)), handlers);
    return handlers;
  }

  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  class Search;

  /// One topic may be several inputs.
  static void add(BagHandlers more, BagHandlers& handlers);
  const Found* find(const std::string& port, slam::Kind kind) const;
  /// Refuses one topic for two sensors of a kind.
  void requireSensorsOfTheirOwn(const BagReader& bag) const;

  slam::DataFlow flow_;
  std::vector<Found> found_;
  std::vector<std::string> left_out_;  ///< keys of components
  std::vector<std::string> notes_, warnings_;
};

}  // namespace slam_ros
