// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/odometry_nodelet.hpp"

#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/report_failure.hpp"

namespace slam_ros {

void OdometryNodelet::onInit() {
  reportFailure(getName(), [this] {
    const auto config = parametersFromRos<OdometryNodeletConfig>(getPrivateNodeHandle());
    const auto name = config.publish_motion ? std::string() : source_;
    node_.emplace(PartNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
                  slam::ProductPart{slam::ProductPart::Extent::kOdometry, name},
                  InputOptions{config.camera.transport, true, true});
    auto& part = node_->part();
    outputs_.emplace(getNodeHandle(), config, part.components().frames, *part.components().odometry,
                     node_->topics().motion,
                     [this](const std::string& sentence) { node_->diagnostics().warn(sentence); });
    node_->onceConnected([this] { outputs_->advertise(); });
    node_->on_reset = [this] { outputs_->reset(); };
    part.listen<slam::Motion>("motion", [this](const auto& motion) {
      outputs_->publish(motion);
      node_->noteOutput();
    });
  });
}

}  // namespace slam_ros
