// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <std_msgs/Header.h>

#include <boost/make_shared.hpp>
#include <new>
#include <stdexcept>

#include "slam_ros/door.hpp"

namespace slam_ros {
namespace {

TEST(Door, LetsCallbacksDoTheirWork) {
  Door door;
  int done = 0;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(door.pass("odom", [&] { ++done; }), "");
  EXPECT_EQ(done, 3);
  EXPECT_EQ(door.fault(), "");
}

TEST(Door, CatchesWhatACallbackThrowsAndNamesTheTopic) {
  Door door;
  const auto told = door.pass("scan", [] { throw std::runtime_error("the tile is gone"); });
  EXPECT_NE(told.find("scan"), std::string::npos) << told;
  EXPECT_NE(told.find("the tile is gone"), std::string::npos) << told;
  EXPECT_EQ(door.fault(), told);
}

TEST(FaultIn, SaysWhatABadAllocMeansAndNothingWhereAllIsWell) {
  EXPECT_NE(faultIn([] { throw std::bad_alloc(); }).find("not enough memory"), std::string::npos);
  EXPECT_EQ(faultIn([] {}), "");
}

TEST(Door, RefusesFurtherInputUntilItIsOpened) {
  Door door;
  door.pass("scan", [] { throw std::bad_alloc(); });
  int done = 0;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(door.pass("scan", [&] { ++done; }), "");
  EXPECT_EQ(done, 0);
  EXPECT_EQ(door.refused(), 5u);
  door.open();
  door.pass("scan", [&] { ++done; });
  EXPECT_EQ(done, 1);
}

TEST(LastMessage, RecognisesAMessageThatComesASecondTime) {
  LastMessage last;
  auto message = boost::make_shared<std_msgs::Header>();
  EXPECT_TRUE(last.isNew(message));
  EXPECT_FALSE(last.isNew(message));
  message = boost::make_shared<std_msgs::Header>();
  EXPECT_TRUE(last.isNew(message)) << "it says the same, but is another one";
}

}  // namespace
}  // namespace slam_ros
