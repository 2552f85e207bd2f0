// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_ros/silence_watch.hpp"

namespace slam_ros {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class SilenceWatchTest : public testing::Test {
 protected:
  void hear(const std::string& input) { EXPECT_EQ(watch.heard(input, now), ""); }
  void pass(milliseconds time) { now += time; }

  SilenceWatch watch;
  SilenceWatch::Clock::time_point now{seconds(1000)};
};

TEST_F(SilenceWatchTest, WhatHasNeverComeIsNotMissed) {
  EXPECT_EQ(watch.sentence(now), "");
  hear("motion");
  pass(seconds(100));
  EXPECT_EQ(watch.sentence(now).find("observations"), std::string::npos);
}

TEST_F(SilenceWatchTest, OneInputThatPausesIsNoSilence) {
  for (int i = 0; i < 50; ++i, pass(milliseconds(100))) {
    hear("motion");
    if (i == 0) hear("observations");
  }
  EXPECT_EQ(watch.sentence(now), "");
  EXPECT_EQ(watch.news(now), "");
  hear("observations");
  pass(seconds(15));
  EXPECT_EQ(watch.sentence(now).find("stale: nothing has come on motion and observations for 15 s"),
            0u);
}

TEST_F(SilenceWatchTest, AGapThatIsUsualIsNone) {
  hear("motion");
  pass(SilenceWatch::kPatience);
  EXPECT_EQ(watch.sentence(now), "");
  hear("motion");
}

TEST_F(SilenceWatchTest, TellsOnceThatASilenceBeginsAndThatItIsOver) {
  hear("motion");
  EXPECT_EQ(watch.news(now), "");
  pass(seconds(4));
  EXPECT_NE(watch.news(now), "");
  pass(seconds(6));
  EXPECT_EQ(watch.news(now), "");
  EXPECT_EQ(watch.heard("motion", now), "motion comes again after 10.0 s without any");
  hear("motion");
  EXPECT_EQ(watch.sentence(now), "");
  pass(seconds(4));
  EXPECT_NE(watch.news(now), "") << "another silence";
}

}  // namespace
}  // namespace slam_ros
