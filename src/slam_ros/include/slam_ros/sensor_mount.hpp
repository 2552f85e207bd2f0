// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace slam_ros {

/// Where a sensor is mounted, read from /tf_static: reported when it is known and when it changes.
class SensorMount {
 public:
  using Sink =
      std::function<void(const std::string& sensor_frame, const Eigen::Isometry3d& T_base_sensor)>;

  /// @param base_frame of the robot
  SensorMount(std::string base_frame, Sink sink);

  void take(const tf2_msgs::TFMessage& static_transforms);
  /// Data of the sensor have come, of this frame.
  void takeFrame(const std::string& sensor_frame);

  bool hasFrame() const { return frame_.has_value(); }
  /// Whether it was reported, if only for data of another frame.
  bool isKnown() const { return told_.has_value(); }
  /// "base_link -> laser" while data came and that transform did not, else empty.
  std::string missing() const;

 private:
  /// Nothing while no transform connects base and sensor. A sensor whose own transform is none
  /// (NaN, no unit quaternion) gets it as it came: slam::faultOfMount() says what is wrong with it.
  std::optional<Eigen::Isometry3d> pose() const;
  void tell();

  std::string base_frame_;
  Sink sink_;
  tf2::BufferCore tree_;
  std::map<std::string, Eigen::Isometry3d> faulty_;  ///< by child frame
  std::optional<std::string> frame_;                 ///< of the newest data
  std::string told_frame_;
  std::optional<Eigen::Isometry3d> told_;
};

/// "the bag's /tf_static does not tell the transform base_link -> laser"; empty where none is
/// missing.
std::string lackOfTransform(const std::string& missing);

}  // namespace slam_ros
