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
/// Data that a component would make and that the bag carries take the component's place, unless the
/// bag has an input of the component that others take as well, or a remapping asks for an input of
/// the component. Where the bag has what the component makes the data of, only a topic of their own
/// name or a remapped one carries them: that of another robot may be of the same type.
class BagInputs {
 public:
  /// @throw TopicError when an input that the product needs is missing (with what the bag has) or
  /// cannot be told, and for a remapping that is wrong or would have no effect; slam::ConfigError
  BagInputs(const BagReader& bag, const slam::ProductComponents& product, const BagContext& context,
            const std::vector<Remap>& remaps);

  struct Found {
    std::string port;
    slam::Kind kind;
    std::unique_ptr<BagInput> input;
  };
  const std::vector<Found>& found() const { return found_; }
  /// The topics of the bag that an input was found on, that of its data first; none: it was not.
  std::vector<std::string> topicsOf(const std::string& port) const;

  const slam::DataFlow& flow() const { return flow_; }
  /// The components that are not left out.
  std::vector<slam::DataFlow::Part> parts() const;
  bool isLeftOut(const std::string& key) const;
  /// Whether the bag has the data, or all of what a component makes them of.
  bool isSupplied(const slam::InputPort& input) const;

  /// Handlers for BagReader::read() that give the sinks of each input what its messages hold.
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
