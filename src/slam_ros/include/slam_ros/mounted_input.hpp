// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>

#include <functional>
#include <string>
#include <utility>

#include "slam_core/imu/imu_reading.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/sensor_mount.hpp"

namespace slam_ros {

/// Turns the messages of a sensor into the inputs of a component; nodelets and slam_offline share
/// it. The mount is passed on when it comes and when it changes. The component holds the data until
/// it has the mount, so that the order of arrival does not matter.
/// @tparam Data content of a message, with its frame @tparam Mount has a frame and a pose
template <class Message, class Data, class Mount>
class MountedInput {
 public:
  struct Sinks {
    std::function<void(const Data&)> data;
    std::function<void(const Mount&)> mount;
  };

  /// @param base_frame of the robot
  MountedInput(std::string base_frame, Sinks sinks)
      : sinks_(std::move(sinks)),
        mount_(std::move(base_frame), [this](const auto& frame, const auto& pose) {
          sinks_.mount({frame, pose});
        }) {}

  void take(const Message& message) {
    const Data data = fromMsg(message);
    mount_.takeFrame(data.frame);
    sinks_.data(data);
  }
  void take(const tf2_msgs::TFMessage& static_transforms) { mount_.take(static_transforms); }

  bool hasData() const { return mount_.hasFrame(); }
  /// "base_link -> laser" if data have come and that transform has not; otherwise empty.
  std::string missingTransform() const { return mount_.missing(); }
  /// Why a bag gives no mount that could be used, as a clause; empty if it does.
  std::string lackOfMount() const { return mount_.lackInBag(); }

 private:
  Sinks sinks_;
  SensorMount mount_;
};

using LaserInput = MountedInput<sensor_msgs::LaserScan, slam::LaserSweep, slam::LaserMount>;
using ImuInput = MountedInput<sensor_msgs::Imu, slam::ImuReading, slam::ImuMount>;

}  // namespace slam_ros
