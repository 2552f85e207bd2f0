// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "bag_maker.hpp"
#include "slam_ros/topic_matching.hpp"

namespace slam_ros {
namespace {

using test::contains;
using test::messageOf;

const Input kOdom{"odom", "odom", "nav_msgs/Odometry", "1"};
const Input kSeen{"observations", "seen", "slam_msgs/LandmarkObservationArray", "2"};
const std::vector<Input> kInputs{kOdom, kSeen};

BagTopic odometryTopic(const std::string& name, std::size_t messages = 7) {
  return {name, kOdom.type, kOdom.md5sum, messages};
}

TEST(TopicMatching, TakesTheNameWhetherOrNotItHasASlash) {
  const auto match =
      matchTopic(kOdom, kInputs, {odometryTopic("/other"), odometryTopic("/odom")}, Names::kAny);
  ASSERT_TRUE(match);
  EXPECT_EQ(match->topic, "/odom");
  EXPECT_EQ(match->note, "");
}

TEST(TopicMatching, TakesTheOnlyOneOfTheTypeAndSaysSo) {
  const auto match = matchTopic(kOdom, kInputs, {odometryTopic("/base/odometry")}, Names::kAny);
  ASSERT_TRUE(match);
  EXPECT_EQ(match->topic, "/base/odometry");
  EXPECT_TRUE(contains(match->note, "/base/odometry is the input odom")) << match->note;
}

TEST(TopicMatching, NamesTheCandidatesWhenSeveralFit) {
  const auto message = messageOf([] {
    matchTopic(kOdom, kInputs, {odometryTopic("/a", 3), odometryTopic("/b", 1)}, Names::kAny);
  });
  EXPECT_TRUE(contains(message,
                       "/a (nav_msgs/Odometry, 3 messages), /b (nav_msgs/Odometry, 1 "
                       "message)"))
      << message;
  EXPECT_TRUE(contains(message, "--remap odom:=/a")) << message;
}

TEST(TopicMatching, FindsNothingInEmptyOrTrueTopicsOrInThoseOfAnotherType) {
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {odometryTopic("/odom", 0)}, Names::kAny));
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {odometryTopic("/ground_truth/odom")}, Names::kAny));
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {{"/odom", "std_msgs/Bool", "3", 9}}, Names::kAny));
}

TEST(TopicMatching, TellsThatATopicWasRecordedWithAnotherVersionOfItsType) {
  const auto message = messageOf([] {
    matchTopic(kOdom, kInputs, {{"/odom", kOdom.type, "old", 9}}, Names::kAny);
  });
  EXPECT_TRUE(contains(message, "another version of nav_msgs/Odometry")) << message;
}

TEST(TopicMatching, TheOwnNameAloneCountsWhereOthersAreNotAskedFor) {
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {odometryTopic("/base/odometry")}, Names::kOwn));
  const auto match =
      matchTopic(kOdom, kInputs, {odometryTopic("/a"), odometryTopic("/odom")}, Names::kOwn);
  ASSERT_TRUE(match);
  EXPECT_EQ(match->topic, "/odom");
}

TEST(TopicMatching, FindsTheProductsOwnNameWhereTheRobotsIsAnother) {
  const Input elsewhere{"odom", "wheels", kOdom.type, kOdom.md5sum};
  const Input other{"second", "second", kOdom.type, kOdom.md5sum};
  const auto match =
      matchTopic(elsewhere, {elsewhere, other}, {odometryTopic("/odom")}, Names::kAny);
  ASSERT_TRUE(match);
  EXPECT_EQ(match->topic, "/odom");
  EXPECT_TRUE(contains(match->note, "/odom is the input odom: the only one of type"))
      << match->note;
  EXPECT_FALSE(matchTopic(elsewhere, {elsewhere, other}, {odometryTopic("/second")}, Names::kAny))
      << "that of another input";
}

}  // namespace
}  // namespace slam_ros
