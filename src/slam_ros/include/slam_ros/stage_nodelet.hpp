// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "slam_ros/checkpoint_config.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/part_node.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/stage_state.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_ros {

/// The nodelet of a stage with one output, which it publishes. A package derives from it, names the
/// stage and exports the plugin; nothing else. It has to run in the process of the back-end's
/// nodelet, whose checkpoints contain its state.
/// @tparam convert from the stage's data to the message
template <class Message, class Data, Message (*convert)(const Data&)>
class StageNodelet : public nodelet::Nodelet {
 public:
  ~StageNodelet() override {
    if (node_) node_->stop();
    if (state_) state_->close();
  }

 protected:
  /// @param stage its name in the registry of stages @param output the name of its output
  StageNodelet(std::string stage, std::string output)
      : stage_(std::move(stage)), output_(std::move(output)) {}

 private:
  void onInit() final {
    reportFailure(getName(), [this] {
      const auto camera = parametersFromRos<TransportConfig>(getPrivateNodeHandle());
      node_.emplace(PartNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
                    slam::ProductPart{slam::ProductPart::Extent::kStage, stage_},
                    InputOptions{camera.transport, true, false});
      topic_ = node_->topics().of(output_);
      node_->part().template listen<Data>(output_, [this](const Data& data) { publish(data); });
      keepState();
      node_->onceConnected(
          [this] { publisher_ = getNodeHandle().advertise<Message>(topic_, kQueue); });
    });
  }

  void keepState() {
    const ros::NodeHandle checkpoints(getNodeHandle(), "checkpoints");
    const bool has_checkpoints = !parametersFromRos<CheckpointConfig>(checkpoints).folder.empty();
    state_ = StageState::of(getNodeHandle().getNamespace(), stage_);
    state_->open(node_->part(), has_checkpoints);
    node_->through = [this](const auto& action) { state_->take(action); };
    node_->waits_for = [this] {
      return state_->isWaiting() ? "waiting for the back-end's checkpoint" : "";
    };
  }

  void publish(const Data& data) {
    if (publisher_) publisher_.publish(boost::make_shared<Message>(convert(data)));
    node_->noteOutput();
  }

  std::string stage_, output_, topic_;
  ros::Publisher publisher_;
  std::shared_ptr<StageState> state_;
  std::optional<PartNode> node_;  // no callback may find what stands above gone
};

}  // namespace slam_ros
