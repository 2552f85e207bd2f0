// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <string>

#include "slam_ros/estimator_node.hpp"

namespace slam_ros {

/// The nodelet of a back-end in the composition pubsub. A back-end's package only derives from it,
/// names the component and exports the plugin.
class BackendNodelet : public nodelet::Nodelet {
 protected:
  /// @param backend its name in the registry of back-ends
  explicit BackendNodelet(std::string backend) : backend_(std::move(backend)) {}

 private:
  void onInit() final;

  std::string backend_;
  slam::MetaCoordinator part_;
  std::unique_ptr<EstimatorNode> node_;
};

}  // namespace slam_ros
