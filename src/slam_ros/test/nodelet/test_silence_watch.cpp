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

TEST_F(SilenceWatchTest, OneInputThatMayPauseIsGivenMoreTime) {
  watch.mayPause("observations");
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

TEST_F(SilenceWatchTest, TellsWhichInputDiedWhileOthersGoOn) {
  watch.mayPause("observations");
  hear("scan");
  hear("observations");
  std::string early;
  for (int i = 0; i < 120; ++i, pass(milliseconds(100))) {
    hear("motion");
    if (i == 35) early = watch.news(now);
  }
  EXPECT_EQ(early.find("stale: nothing has come on scan for 4 s, while other inputs go on"), 0u)
      << early;
  EXPECT_EQ(watch.sentence(now).find("stale: nothing has come on observations and scan for 12 s"),
            0u)
      << watch.sentence(now);
  EXPECT_NE(watch.news(now), "") << "of the observations";
  EXPECT_EQ(watch.news(now), "");
  EXPECT_EQ(watch.heard("scan", now), "scan comes again after 12.0 s without any");
  EXPECT_EQ(watch.sentence(now).find("stale: nothing has come on observations for 12 s"), 0u);
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
