// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>

#include "slam_ros/estimator_node.hpp"

namespace slam_ros {

/// The nodelet of a back-end in the composition pubsub. A back-end's package derives from it, says
/// which component it is and exports the plugin; nothing else.
class BackendNodelet : public nodelet::Nodelet {
 protected:
  virtual std::unique_ptr<slam::Backend> makeBackend() const = 0;

 private:
  void onInit() final;

  std::unique_ptr<BackendAlone> source_;
  std::unique_ptr<EstimatorNode> node_;
};

}  // namespace slam_ros
