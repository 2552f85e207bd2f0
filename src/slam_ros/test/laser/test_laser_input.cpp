// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "slam_ros/mounted_input.hpp"

namespace slam_ros {
namespace {

tf2_msgs::TFMessage edge(const std::string& parent, const std::string& child, double x,
                         double roll = 0.0) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  auto& transform = message.transforms.front();
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.rotation.x = std::sin(roll / 2);
  transform.transform.rotation.w = std::cos(roll / 2);
  return message;
}

sensor_msgs::LaserScan scan(const std::string& frame) {
  sensor_msgs::LaserScan message;
  message.header.frame_id = frame;
  message.header.stamp = ros::Time(7, 5);
  message.angle_min = -0.1f;
  message.angle_max = 0.1f;
  message.angle_increment = 0.1f;
  message.range_min = 0.2f;
  message.range_max = 9.0f;
  message.ranges = {1, 2, std::numeric_limits<float>::infinity()};
  message.intensities = {1, 2, 3, 4, 5, 6, 7};  // of a wrong length
  return message;
}

/// What came out, in order.
struct LaserInputTest : ::testing::Test {
  LaserInput laser{"base_link",
                   {[this](const slam::LaserSweep& known) {
                      came.push_back("scan");
                      sweep = known;
                    },
                    [this](const slam::LaserMount& known) {
                      came.push_back("mount");
                      mount = known;
                    }}};
  std::vector<std::string> came;
  slam::LaserSweep sweep;
  slam::LaserMount mount;
};

using Order = std::vector<std::string>;

TEST_F(LaserInputTest, PassesTheScanOnAsItCameWhateverItsIntensities) {
  laser.take(scan("/laser"));
  EXPECT_EQ(sweep.frame, "laser");
  EXPECT_EQ(slam::nanoseconds(sweep.stamp), 7000000005);
  EXPECT_EQ(sweep.ranges, scan("").ranges);
  EXPECT_EQ(sweep.range_max, 9.0f);
  EXPECT_EQ(slam::faultOf(sweep), "");
}

TEST_F(LaserInputTest, TheMountIsTheWholeChainOfTransforms) {
  laser.take(edge("base_link", "mast", 1.0));
  laser.take(edge("mast", "laser", 0.5, M_PI));
  laser.take(scan("laser"));
  EXPECT_EQ(came, (Order{"mount", "scan"}));
  EXPECT_EQ(mount.frame, "laser");
  EXPECT_DOUBLE_EQ(mount.T_base_laser.translation().x(), 1.5);
  EXPECT_DOUBLE_EQ(mount.T_base_laser.linear()(2, 2), -1.0);
}

TEST_F(LaserInputTest, ATransformThatComesAfterTheScanIsPassedOnThenAndOnce) {
  laser.take(scan("laser"));
  EXPECT_EQ(laser.missingTransform(), "base_link -> laser");
  for (int i = 0; i < 2; ++i) laser.take(edge("base_link", "laser", 1.0));
  EXPECT_EQ(came, (Order{"scan", "mount"}));
  EXPECT_EQ(laser.missingTransform(), "");
}

TEST_F(LaserInputTest, AScanThatNamesNoFrameSaysSo) {
  laser.take(scan(""));
  EXPECT_EQ(laser.missingTransform(), "base_link -> (no frame)");
}

}  // namespace
}  // namespace slam_ros
