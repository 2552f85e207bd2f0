// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "slam_ros/mounted_input.hpp"

namespace slam_ros {
namespace {

TEST(ImuInput, PassesReadingsOnAsTheyCameAndTheMountOnce) {
  std::vector<std::string> came;
  slam::ImuReading reading;
  slam::ImuMount mount;
  ImuInput imu("base_link", {[&](const auto& known) {
                               came.push_back("reading");
                               reading = known;
                             },
                             [&](const auto& known) {
                               came.push_back("mount");
                               mount = known;
                             }});
  sensor_msgs::Imu message;
  message.header.frame_id = "/imu_link";
  message.header.stamp = ros::Time(7, 5);
  message.angular_velocity.x = 1.0;
  message.angular_velocity.z = -2.0;
  message.angular_velocity_covariance = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  imu.take(message);
  EXPECT_EQ(imu.missingTransform(), "base_link -> imu_link");
  tf2_msgs::TFMessage transforms;
  transforms.transforms.resize(1);
  transforms.transforms[0].header.frame_id = "base_link";
  transforms.transforms[0].child_frame_id = "imu_link";
  transforms.transforms[0].transform.rotation.x = 1.0;  // upside down
  imu.take(transforms);
  imu.take(message);
  EXPECT_EQ(came, (std::vector<std::string>{"reading", "mount", "reading"}));
  EXPECT_EQ(imu.missingTransform(), "");
  EXPECT_EQ(reading.frame, "imu_link");
  EXPECT_EQ(slam::nanoseconds(reading.stamp), 7000000005);
  EXPECT_EQ(reading.angular_velocity, Eigen::Vector3d(1.0, 0.0, -2.0));
  EXPECT_EQ(reading.covariance(0, 1), 2.0);
  EXPECT_EQ(mount.frame, "imu_link");
  EXPECT_DOUBLE_EQ(mount.T_base_imu.linear()(2, 2), -1.0);
}

}  // namespace
}  // namespace slam_ros
