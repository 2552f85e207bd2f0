// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_ros/warning_log.hpp"

namespace slam_ros {
namespace {

const std::string kLost = "no observation fits the map, all are gated: the pose may be lost";

std::string moved(int id, int times) {
  return "landmark " + std::to_string(id) + " was not where the map has it " +
         std::to_string(times) + " times in a row: was it moved?";
}

/// A kind of its own for each letter.
std::string lettered(int i) {
  return std::string("camera '") + static_cast<char>('a' + i % 26) +
         static_cast<char>('a' + i / 26) + "' is unknown";
}

TEST(WarningLog, TellsSentencesApartWithoutTheirNumbers) {
  EXPECT_EQ(WarningLog::kindOf(moved(3, 10)), WarningLog::kindOf(moved(17, 121)));
  EXPECT_EQ(WarningLog::kindOf("landmark 3, 7, 12 is begun anew"),
            WarningLog::kindOf("landmark -3 is begun anew"));
  EXPECT_EQ(WarningLog::kindOf("a jump of 1e+06 m at 12.25"), "a jump of # m at #");
  EXPECT_EQ(WarningLog::kindOf("(3 of 4)"), "(# of #)");
  EXPECT_NE(WarningLog::kindOf("frame 'laser1' is unknown"),
            WarningLog::kindOf("frame 'laser2' is unknown"));
  EXPECT_NE(WarningLog::kindOf("topic /camera/1 is silent"),
            WarningLog::kindOf("topic /camera/2 is silent"));
}

TEST(WarningLog, SaysTheFirstOfAKindAndCountsTheOthers) {
  WarningLog log;
  EXPECT_EQ(log.add(moved(0, 10)), moved(0, 10));
  for (int id = 1; id < 30; ++id) EXPECT_EQ(log.add(moved(id, 10)), "");
  EXPECT_EQ(log.add("once"), "once");
  ASSERT_EQ(log.summary().size(), 1u) << "what was said each time is not repeated";
  EXPECT_EQ(log.summary().front(), "warned 30 times: " + moved(0, 10));
}

TEST(WarningLog, NumberedWarningsLeaveRoomForOthers) {
  WarningLog log;
  for (int id = 0; id < 100; ++id) log.add(moved(id, 10));
  EXPECT_EQ(log.add(kLost), kLost);
}

TEST(WarningLog, UrgentOnesAreSaidHoweverManyThereWereBefore) {
  WarningLog log;
  int said = 0;
  for (int i = 0; i < 50; ++i) said += log.add(lettered(i)) == lettered(i) ? 1 : 0;
  EXPECT_EQ(said, static_cast<int>(WarningLog::kMostSaid));
  EXPECT_EQ(log.add(kLost, true), kLost);
  EXPECT_EQ(log.add(kLost, true), "");
  const auto summary = log.summary();
  ASSERT_EQ(summary.size(), 41u);
  EXPECT_EQ(summary[0], "warned 2 times: " + kLost);
  EXPECT_EQ(summary[1], "warned 1 time: " + lettered(10));
}

TEST(WarningLog, ThatThereAreMoreIsSaidOnce) {
  WarningLog log;
  for (int i = 0; i < 10; ++i) log.add(lettered(i));
  EXPECT_EQ(log.add(lettered(10)), "further ones are counted at the end");
  EXPECT_EQ(log.add(lettered(11)), "");
}

TEST(WarningLog, NamesInBadDataDoNotFillTheMemory) {
  WarningLog log;
  for (int i = 0; i < 600; ++i) log.add(lettered(i));
  EXPECT_EQ(log.summary().size(), 191u);
  EXPECT_EQ(log.summary().back(), "400 warnings of further kinds");
  EXPECT_EQ(log.add(kLost, true), kLost);
}

}  // namespace
}  // namespace slam_ros
