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
      matchTopic(kOdom, kInputs, {odometryTopic("/other"), odometryTopic("/odom")}, {});
  ASSERT_TRUE(match);
  EXPECT_EQ(match->topic, "/odom");
  EXPECT_EQ(match->note, "");
}

TEST(TopicMatching, TakesTheOnlyOneOfTheTypeAndSaysSo) {
  const auto match = matchTopic(kOdom, kInputs, {odometryTopic("/base/odometry")}, {});
  ASSERT_TRUE(match);
  EXPECT_EQ(match->topic, "/base/odometry");
  EXPECT_TRUE(contains(match->note, "/base/odometry is the input odom")) << match->note;
}

TEST(TopicMatching, NamesTheCandidatesWhenSeveralFit) {
  const auto message = messageOf([] {
    matchTopic(kOdom, kInputs, {odometryTopic("/a", 3), odometryTopic("/b", 1)}, {});
  });
  EXPECT_TRUE(contains(message,
                       "/a (nav_msgs/Odometry, 3 messages), /b (nav_msgs/Odometry, 1 "
                       "message)"))
      << message;
  EXPECT_TRUE(contains(message, "--remap odom:=/a")) << message;
}

TEST(TopicMatching, FindsNothingInEmptyOrTrueTopicsOrInThoseOfAnotherType) {
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {odometryTopic("/odom", 0)}, {}));
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {odometryTopic("/ground_truth/odom")}, {}));
  EXPECT_FALSE(matchTopic(kOdom, kInputs, {{"/odom", "std_msgs/Bool", "3", 9}}, {}));
}

TEST(TopicMatching, TellsThatATopicWasRecordedWithAnotherVersionOfItsType) {
  const auto message = messageOf([] {
    matchTopic(kOdom, kInputs, {{"/odom", kOdom.type, "old", 9}}, {});
  });
  EXPECT_TRUE(contains(message, "another version of nav_msgs/Odometry")) << message;
}

TEST(TopicMatching, ARemappingDecidesBetweenTopicsAndIsReadBothWays) {
  const std::vector<BagTopic> topics{odometryTopic("/odom"), odometryTopic("/b")};
  for (const auto& remap : {Remap{"odom", "/b"}, Remap{"/b", "odom"}}) {
    const auto match = matchTopic(kOdom, kInputs, topics, {remap});
    ASSERT_TRUE(match);
    EXPECT_EQ(match->topic, "/b");
  }
}

TEST(TopicMatching, ATopicRemappedToOneInputIsNoCandidateForAnother) {
  const Input other{"second", "second", kOdom.type, kOdom.md5sum};
  EXPECT_FALSE(matchTopic(kOdom, {kOdom, other}, {odometryTopic("/b")}, {{"second", "/b"}}));
}

TEST(TopicMatching, ARemappingToAnotherTypeSaysWhatIsNeeded) {
  const auto message = messageOf([] {
    matchTopic(kOdom, kInputs, {{"/scan", "sensor_msgs/LaserScan", "3", 9}}, {{"odom", "/scan"}});
  });
  EXPECT_TRUE(contains(message, "type sensor_msgs/LaserScan, needed are nav_msgs/Odometry"))
      << message;
}

TEST(TopicMatching, ARemappingThatJoinsNothingNamesInputsAndTopics) {
  const auto message = messageOf([] {
    checkRemaps({{"odm", "/b"}}, kInputs, {odometryTopic("/b")});
  });
  EXPECT_TRUE(contains(message, "did you mean 'odom'")) << message;
  EXPECT_TRUE(contains(message, "/b (nav_msgs/Odometry")) << message;
  EXPECT_NO_THROW(checkRemaps({{"seen", "/b"}}, kInputs, {odometryTopic("/b")}));
}

TEST(Remap, IsReadWithAndWithoutColonAndElseRefused) {
  for (const auto* text : {"odom:=/b", "odom=/b"}) {
    EXPECT_EQ(parseRemap(text).from, "odom") << text;
    EXPECT_EQ(parseRemap(text).to, "/b") << text;
  }
  for (const auto* text : {"odom", "odom:=", ":=/b", "=/b", ""})
    EXPECT_THROW(parseRemap(text), TopicError) << text;
}

}  // namespace
}  // namespace slam_ros
