// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <ros/serialization.h>

#include "slam_ros/thinned_path.hpp"

namespace slam_ros {
namespace {

geometry_msgs::PoseStamped pose(std::uint32_t number) {
  geometry_msgs::PoseStamped message;
  message.header.stamp = ros::Time(number + 1, 0);
  message.header.frame_id = "map";
  message.pose.position.x = number;
  return message;
}

TEST(ThinnedPath, HasAllPosesOfAShortRun) {
  ThinnedPath path("map");
  for (std::uint32_t i = 0; i < 3999; ++i) path.add(pose(i));
  EXPECT_EQ(path.message().header.frame_id, "map");
  EXPECT_EQ(path.message().header.stamp, ros::Time(3999, 0));
  ASSERT_EQ(path.message().poses.size(), 3999u);
  for (std::uint32_t i = 0; i < 3999; ++i) EXPECT_EQ(path.message().poses[i].pose.position.x, i);
}

TEST(ThinnedPath, StaysBoundedAndEvenFromTheFirstPoseToTheLast) {
  ThinnedPath path("map");
  std::uint32_t largest = 0;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    path.add(pose(i));
    const auto& poses = path.message().poses;
    ASSERT_LE(poses.size(), ThinnedPath::kMostPoses) << i;
    ASSERT_EQ(poses.front().pose.position.x, 0.0) << i;
    ASSERT_EQ(poses.back().pose.position.x, i);
    largest = std::max(largest, ros::serialization::serializationLength(path.message()));
  }
  EXPECT_LT(largest, 400'000u) << "bytes of a message";
  const auto& poses = path.message().poses;
  EXPECT_GT(poses.size(), ThinnedPath::kMostPoses / 3);
  const double step = poses[1].pose.position.x - poses[0].pose.position.x;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i)
    ASSERT_EQ(poses[i].pose.position.x - poses[i - 1].pose.position.x, step) << i;
  EXPECT_LE(poses.back().pose.position.x - poses[poses.size() - 2].pose.position.x, step);
}

}  // namespace
}  // namespace slam_ros
