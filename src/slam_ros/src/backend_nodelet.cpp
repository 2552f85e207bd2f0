// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/backend_nodelet.hpp"

#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/report_failure.hpp"

namespace slam_ros {

void BackendNodelet::onInit() {
  reportFailure(getName(), [this] {
    node_ = std::make_unique<EstimatorNode>(
        EstimatorNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
        parametersFromRos<OutputsConfig>(getPrivateNodeHandle()), part_,
        slam::ProductPart{slam::ProductPart::Extent::kBackend, backend_});
  });
}

}  // namespace slam_ros
