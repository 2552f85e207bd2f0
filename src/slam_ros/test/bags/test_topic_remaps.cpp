// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "bag_maker.hpp"
#include "slam_ros/bag_search.hpp"

namespace slam_ros {
namespace {

using test::contains;
using test::messageOf;

const Input kWheels{"odom", "wheels", "nav_msgs/Odometry", "1"};
const Input kLandmarks{"observations", "seen", "slam_msgs/LandmarkObservationArray", "2"};
const std::vector<Input> kBoth{kWheels, kLandmarks};

BagTopic wheelsOn(const std::string& name, std::size_t messages = 7) {
  return {name, kWheels.type, kWheels.md5sum, messages};
}

/// What remappings are refused with.
std::string faultOf(const std::vector<Remap>& remaps, const std::vector<BagTopic>& topics) {
  return messageOf([&] { chooseTopics(remaps, kBoth, topics); });
}

TEST(TopicRemaps, AreReadBothWaysByTheInputsNameOrTheRobotsTopic) {
  const std::vector<BagTopic> topics{wheelsOn("/odom"), wheelsOn("/b")};
  for (const auto& remap :
       {Remap{"odom", "/b"}, Remap{"/b", "odom"}, Remap{"wheels", "b"}, Remap{"/b", "/wheels"}}) {
    const auto chosen = chooseTopics({remap}, kBoth, topics);
    ASSERT_EQ(chosen.size(), 1u);
    EXPECT_EQ(chosen[0].input.name, "odom");
    EXPECT_EQ(chosen[0].topic, "/b");
  }
}

TEST(TopicRemaps, ThatJoinNothingAreToldWithInputsAndTopics) {
  const auto fault = faultOf({{"odm", "/b"}}, {wheelsOn("/b")});
  EXPECT_TRUE(contains(fault, "odm:=/b joins no input with a topic of the bag")) << fault;
  EXPECT_TRUE(contains(fault, "did you mean 'odom'")) << fault;
  EXPECT_TRUE(contains(fault, "/b (nav_msgs/Odometry")) << fault;
}

TEST(TopicRemaps, ToATopicThatCannotBeTheInputAreToldWithWhatIsNeeded) {
  EXPECT_EQ(faultOf({{"odom", "/scan"}}, {{"/scan", "sensor_msgs/LaserScan", "3", 9}}),
            "the topic /scan cannot be the input odom: it has messages of type "
            "sensor_msgs/LaserScan, needed are nav_msgs/Odometry; name another topic");
  EXPECT_EQ(faultOf({{"odom", "/b"}}, {wheelsOn("/b", 0)}),
            "the topic /b cannot be the input odom: it has no messages; name another topic");
  EXPECT_TRUE(contains(faultOf({{"odom", "/b"}}, {{"/b", kWheels.type, "old", 9}}),
                       "another version of nav_msgs/Odometry"));
}

TEST(TopicRemaps, TwoOfOneInputAreRefused) {
  const std::vector<BagTopic> topics{wheelsOn("/a"), wheelsOn("/b")};
  EXPECT_EQ(
      faultOf({{"odom", "/a"}, {"/b", "wheels"}}, topics),
      "the remappings odom:=/a and /b:=wheels are of the same input 'odom'; leave one of them "
      "out");
}

TEST(TopicRemaps, DecideBetweenTopicsAndTakeThemFromOtherInputs) {
  const Input other{"second", "second", kWheels.type, kWheels.md5sum};
  BagSearch bag({wheelsOn("/wheels"), wheelsOn("/b")}, nullptr, {kWheels, other},
                {{"second", "/b"}});
  EXPECT_EQ(bag.topic(other), "/b");
  EXPECT_TRUE(bag.isRemapped(other));
  EXPECT_FALSE(bag.isRemapped(kWheels));
  EXPECT_EQ(bag.notes, std::vector<std::string>{"/b is the input second"});
  EXPECT_EQ(
      BagSearch({wheelsOn("/b")}, nullptr, {kWheels, other}, {{"second", "/b"}}).topic(kWheels),
      "");
  bag.names = Names::kOwn;
  EXPECT_EQ(bag.topic(other), "/b") << "what is chosen needs no name of its own";
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
