// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>

namespace slam_ros {

/// The tree of /tf_static, from which a sensor's mounting is read.
class StaticTransforms {
 public:
  void set(const tf2_msgs::TFMessage& message);

  /// A sensor's frame in the base frame; nothing while no transform connects the two. A sensor
  /// whose own transform is none (NaN, no unit quaternion) gets it as it came: slam::faultOfMount()
  /// says what is wrong with it.
  std::optional<Eigen::Isometry3d> mount(const std::string& base_frame,
                                         const std::string& sensor_frame) const;

 private:
  tf2::BufferCore tree_;
  std::map<std::string, Eigen::Isometry3d> faulty_;  ///< by child frame
};

/// "the bag's /tf_static does not tell the transform base_link -> laser"; empty where none is
/// missing.
std::string lackOfTransform(const std::string& missing);

}  // namespace slam_ros
