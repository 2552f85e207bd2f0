// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <thread>

#include "slam_ros/background.hpp"
#include "slam_ros/grid_publisher.hpp"
#include "slam_ros/points_publisher.hpp"

namespace slam_ros {
namespace {

TEST(GridMessage, HasTheCellsAsTheyAreWithTheirPlace) {
  slam::OccupancyGrid grid;
  grid.resolution = 0.05;
  grid.origin = {-1.5, 2.0};
  grid.width = 3;
  grid.height = 2;
  grid.cells = {0, 100, -1, 20, 65, 99};
  const auto message = toMsg(grid, slam::stampFromNanoseconds(1500000000), "map");
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(1, 500000000));
  EXPECT_FLOAT_EQ(message.info.resolution, 0.05f);
  EXPECT_EQ(message.info.width, 3u);
  EXPECT_EQ(message.info.height, 2u);
  EXPECT_EQ(message.info.origin.position.x, -1.5);
  EXPECT_EQ(message.info.origin.position.y, 2.0);
  EXPECT_EQ(message.info.origin.orientation.w, 1.0);
  EXPECT_EQ(message.data, grid.cells);
}

TEST(PointsMessage, HasAnXyziForEachPoint) {
  const auto message =
      toMsg({{{1.5, -2.0}, 3}, {{4.0, 5.0}, 1}}, slam::stampFromNanoseconds(1), "map");
  EXPECT_EQ(message.width * message.height, 2u);
  ASSERT_EQ(message.fields.size(), 4u);
  EXPECT_EQ(message.fields[1].name, "y");
  EXPECT_EQ(message.fields[1].offset, 4u);
  ASSERT_EQ(message.data.size(), 2 * message.point_step);
  float first[4];
  std::memcpy(first, message.data.data(), sizeof(first));
  EXPECT_EQ(first[0], 1.5f);
  EXPECT_EQ(first[1], -2.0f);
  EXPECT_EQ(first[2], 0.0f);
  EXPECT_EQ(first[3], 3.0f);
}

TEST(Background, TakesOnePieceOfWorkAtATimeAndEndsIt) {
  std::atomic<bool> go{false};
  std::atomic<int> done{0};
  {
    Background background;
    EXPECT_TRUE(background.tryRun([&] {
      while (!go) std::this_thread::yield();
      ++done;
    }));
    EXPECT_FALSE(background.tryRun([&] { done += 100; })) << "the first is not done";
    go = true;
  }
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace slam_ros
