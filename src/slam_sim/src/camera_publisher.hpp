// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <mutex>

#include "slam_sim/sensors.hpp"

namespace slam::sim {

/// The topics of one live camera: NAME/camera_info always, NAME/image_raw and
/// NAME/image_raw/compressed while somebody subscribes. A picture that is due while the last one is
/// being made is left out.
class CameraPublisher {
 public:
  CameraPublisher(ros::NodeHandle handle, const CameraModel& model, std::size_t index);

  /// Whether somebody subscribes to its pictures.
  bool isWanted() const;
  /// From any thread.
  /// @param time since the start [s]
  void publish(const ros::Time& stamp, const Sensors& sensors, const BasePath& T_world_base,
               double time);

 private:
  CameraModel model_;
  std::size_t index_;
  std::uint64_t images_ = 0;
  std::mutex busy_;
  ros::Publisher info_, raw_, compressed_;
};

}  // namespace slam::sim
