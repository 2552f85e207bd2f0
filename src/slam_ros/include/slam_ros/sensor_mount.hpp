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

/// Reads the mount of a sensor from /tf_static, and reports it when it becomes known and when it
/// changes.
class SensorMount {
 public:
  using Sink =
      std::function<void(const std::string& sensor_frame, const Eigen::Isometry3d& T_base_sensor)>;

  /// @param base_frame of the robot
  SensorMount(std::string base_frame, Sink sink);

  void take(const tf2_msgs::TFMessage& static_transforms);
  /// To be called when data of the sensor have come, in this frame.
  void takeFrame(const std::string& sensor_frame);

  bool hasFrame() const { return frame_.has_value(); }
  /// Why the static transforms of a bag give no mount that could be used, as a clause; empty if
  /// they give one, even if only for data of another frame.
  std::string lackInBag() const;
  /// "base_link -> laser" if data have come and that transform has not; otherwise empty.
  std::string missing() const;

 private:
  /// The result is empty while no transform connects base and sensor. An invalid transform of the
  /// sensor itself (NaN, no unit quaternion) is passed on unchanged: slam::faultOfMount() says what
  /// is wrong with it.
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

}  // namespace slam_ros
