// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_messages.hpp"

#include <tf2_msgs/TFMessage.h>

#include "messages.hpp"

namespace slam::eval {
namespace {

// A reading nearer than this is none [m].
constexpr float kMinRange = 0.01f;

}  // namespace

sensor_msgs::LaserScan toMessage(const LaserReading& reading, std::int64_t stamp,
                                 const std::string& frame) {
  sensor_msgs::LaserScan message;
  message.header.stamp = toTime(stamp);
  message.header.frame_id = frame;
  message.angle_min = static_cast<float>(reading.start_angle);
  message.angle_increment = static_cast<float>(reading.increment);
  const auto steps = reading.ranges.empty() ? 0.0 : static_cast<double>(reading.ranges.size() - 1);
  message.angle_max = static_cast<float>(reading.start_angle + steps * reading.increment);
  message.range_min = kMinRange;
  message.range_max = static_cast<float>(reading.max_range);
  message.ranges = reading.ranges;
  return message;
}

void addLaserMount(BagWriter& bag, const std::string& frame,
                   const geometry_msgs::Pose& T_base_laser) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "base_link";
  transform.child_frame_id = frame;
  transform.transform.translation.x = T_base_laser.position.x;
  transform.transform.translation.y = T_base_laser.position.y;
  transform.transform.translation.z = T_base_laser.position.z;
  transform.transform.rotation = T_base_laser.orientation;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  bag.addFirst("/tf_static", message);
}

}  // namespace slam::eval
