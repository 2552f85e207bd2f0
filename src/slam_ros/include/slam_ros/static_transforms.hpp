// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <string>

#include "slam_core/camera/camera_calibration.hpp"

namespace slam_ros {

/// The tree of /tf_static, from which a sensor's mounting is read.
class StaticTransforms {
 public:
  /// What is not a transform (NaN, no quaternion) is left out; tf2 tells the console.
  void set(const tf2_msgs::TFMessage& message);

  /// The camera's optical frame in the base frame; nothing while no transform connects the two.
  std::optional<slam::CameraMount> mount(const std::string& base_frame,
                                         const std::string& camera_frame) const;

 private:
  tf2::BufferCore tree_;
};

}  // namespace slam_ros
