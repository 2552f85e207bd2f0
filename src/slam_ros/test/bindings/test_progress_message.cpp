// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_ros/conversions.hpp"
#include "slam_ros/progress_message.hpp"

namespace slam_ros {
namespace {

slam::Stamp at(double seconds) { return slam::Stamp(slam::durationFromSeconds(seconds)); }

TEST(ProgressMessage, TellsOfInputsWithAFieldAndOfOthersByName) {
  slam_msgs::Progress message;
  setProgress(message, "scan", at(1));
  setProgress(message, "beacons", at(2));
  EXPECT_EQ(message.scans, toRos(at(1)));
  EXPECT_EQ(message.inputs, std::vector<std::string>{"beacons"});
  const auto newest = progressOf(message);
  EXPECT_EQ(newest.at(progressName("scan")), at(1));
  EXPECT_EQ(newest.at(progressName("beacons")), at(2));
  EXPECT_EQ(newest.at("observations"), slam::Stamp()) << "none has come";
}

TEST(ProgressMessage, AListThatIsTooShortIsReadAsFarAsItGoes) {
  slam_msgs::Progress message;
  message.inputs = {"beacons", "sonar"};
  message.newest = {toRos(at(3))};
  EXPECT_EQ(progressOf(message).count("sonar"), 0u);
}

}  // namespace
}  // namespace slam_ros
