// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <thread>

#include "bag_maker.hpp"
#include "found_inputs.hpp"
#include "slam_ros/bag_reader.hpp"
#include "slam_ros/bag_transforms.hpp"

namespace {

/// The bytes of an array of observations as they were written when all landmarks were points, and
/// when none had a descriptor.
struct EarlierObservations {
  std::vector<std::uint8_t> bytes;
};
struct PointObservations : EarlierObservations {
  static constexpr const char* kMd5Sum = "4d86d73cdfcf3dec4ab59a5ebc938d7b";
  static constexpr std::size_t kAdded = 25;  // [B] of an observation since then
};
struct PlainObservations : EarlierObservations {
  static constexpr const char* kMd5Sum = "db61b129d3736d6ddb520d68f8481a23";
  static constexpr std::size_t kAdded = 8;
};

template <class Message>
struct EarlierMd5Sum {
  static const char* value() { return Message::kMd5Sum; }
  static const char* value(const Message&) { return value(); }
};
struct EarlierDataType {
  static const char* value() { return "slam_msgs/LandmarkObservationArray"; }
  static const char* value(const EarlierObservations&) { return value(); }
};
struct EarlierDefinition {
  static const char* value() { return "Header header"; }
  static const char* value(const EarlierObservations&) { return value(); }
};
struct EarlierSerializer {
  template <class Stream>
  static void write(Stream& stream, const EarlierObservations& message) {
    std::memcpy(stream.advance(serializedLength(message)), message.bytes.data(),
                message.bytes.size());
  }
  static std::uint32_t serializedLength(const EarlierObservations& message) {
    return static_cast<std::uint32_t>(message.bytes.size());
  }
};

}  // namespace

namespace ros {
namespace message_traits {
template <>
struct MD5Sum<PointObservations> : EarlierMd5Sum<PointObservations> {};
template <>
struct MD5Sum<PlainObservations> : EarlierMd5Sum<PlainObservations> {};
template <>
struct DataType<PointObservations> : EarlierDataType {};
template <>
struct DataType<PlainObservations> : EarlierDataType {};
template <>
struct Definition<PointObservations> : EarlierDefinition {};
template <>
struct Definition<PlainObservations> : EarlierDefinition {};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<PointObservations> : EarlierSerializer {};
template <>
struct Serializer<PlainObservations> : EarlierSerializer {};
}  // namespace serialization
}  // namespace ros

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::messageOf;

struct BagFile : ::testing::Test {
  std::string faultOf(const std::string& name) const {
    return messageOf([&] { BagReader(folder / name); });
  }
  BagInputs find(const std::string& name) const {
    return test::findInputs(BagReader(folder / name));
  }
  test::Folder folder;
};

TEST_F(BagFile, ThatCannotBeReadIsToldByNameAndCause) {
  folder.write("text.bag", "this is no bag\n");
  folder.write("empty.bag", "");
  std::filesystem::create_directory(folder / "folder.bag");
  EXPECT_TRUE(contains(faultOf("missing.bag"), "there is no such file"));
  EXPECT_TRUE(contains(faultOf("folder.bag"), "it is a folder"));
  for (const auto* name : {"text.bag", "empty.bag"}) {
    EXPECT_TRUE(contains(faultOf(name), "it is not a bag")) << faultOf(name);
    EXPECT_TRUE(contains(faultOf(name), name)) << faultOf(name);
  }
}

TEST_F(BagFile, CutOffAnywhereIsToldAndNeverReadAsIfItWereWhole) {
  BagMaker(folder / "whole.bag").addOdometry();
  const auto content = folder.read("whole.bag");
  for (const double share : {0.2, 0.5, 0.9, 0.999}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(content.size()));
    folder.write("part.bag", content.substr(0, size));
    EXPECT_TRUE(contains(faultOf("part.bag"), "cannot read the bag")) << share;
  }
}

TEST_F(BagFile, ListsTopicsWithTypesAndCounts) {
  BagMaker(folder / "x.bag").addOdometry().addObservations();
  const BagReader bag(folder / "x.bag");
  EXPECT_EQ(listTopics(bag.topics()),
            "/observations (slam_msgs/LandmarkObservationArray, 17 messages), /odom "
            "(nav_msgs/Odometry, 81 messages)");
  EXPECT_EQ(bag.end() - bag.begin(), std::chrono::seconds(4));
}

template <class Earlier>
Earlier twoEarlierObservations() {
  constexpr std::size_t kToday = 81, kCount = 2;  // [B] of an observation without a descriptor
  slam_msgs::LandmarkObservationArray message;
  message.header.stamp = test::at(0.5);
  message.header.frame_id = "camera";
  message.observations.resize(kCount);
  message.observations[0].id = 3;
  message.observations[1].id = 5;
  message.observations[1].range = 2.5;
  message.observations[1].covariance[3] = 0.25;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto end = bytes.end() - static_cast<std::ptrdiff_t>(i * (kToday - Earlier::kAdded));
    bytes.erase(end - Earlier::kAdded, end);
  }
  Earlier earlier;
  earlier.bytes = bytes;
  return earlier;
}

template <class Earlier>
void expectReadAsToday(const test::Folder& folder) {
  using Message = slam_msgs::LandmarkObservationArray;
  rosbag::Bag(folder / "x.bag", rosbag::bagmode::Write)
      .write("/observations", test::at(0.5), twoEarlierObservations<Earlier>());
  const BagReader bag(folder / "x.bag");
  EXPECT_EQ(bag.topics().at(0).md5sum, ros::message_traits::MD5Sum<Message>::value());
  std::vector<Message> read;
  bag.read({{"/observations", [&](const BagMessage& message) {
               CheckedStream(message.bytes).next(read.emplace_back());
             }}});
  ASSERT_EQ(read.size(), 1u);
  ASSERT_EQ(read[0].observations.size(), 2u);
  EXPECT_EQ(read[0].header.frame_id, "camera");
  EXPECT_EQ(read[0].observations[0].id, 3);
  EXPECT_EQ(read[0].observations[1].id, 5);
  EXPECT_EQ(read[0].observations[1].range, 2.5);
  EXPECT_EQ(read[0].observations[1].covariance[3], 0.25);
  EXPECT_EQ(read[0].observations[1].kind, slam_msgs::LandmarkObservation::POINT);
  EXPECT_TRUE(read[0].observations[1].descriptor.empty());
}

TEST_F(BagFile, OfTheTimeWhenAllLandmarksWerePointsIsReadAsOneOfToday) {
  expectReadAsToday<PointObservations>(folder);
}

TEST_F(BagFile, OfTheTimeWhenNoLandmarkHadADescriptorIsReadAsOneOfToday) {
  expectReadAsToday<PlainObservations>(folder);
}

TEST_F(BagFile, IsReadInTheOrderOfItsTimesAcrossTopics) {
  BagMaker(folder / "x.bag").addOdometry().addObservations();
  const BagReader bag(folder / "x.bag");
  std::vector<slam::Stamp> stamps;
  BagSinks sinks;
  sinks.put = [&](const slam::Datum&, slam::Stamp stamp) { stamps.push_back(stamp); };
  const auto inputs = find("x.bag");
  bag.read(inputs.readers([&](const auto&) { return sinks; }));
  EXPECT_EQ(stamps.size(), 98u);
  EXPECT_TRUE(std::is_sorted(stamps.begin(), stamps.end()));
}

/// Nodelets are loaded while a bag is read. A thread that loads a plugin holds a lock, for which
/// the process that reads the bag would wait in vain.
TEST_F(BagFile, IsReadWhileAnotherThreadLoadsPlugins) {
  BagMaker(folder / "x.bag").addOdometry();
  EXPECT_EQ(faultOf("x.bag"), "");  // the first one loads a plugin itself
  std::atomic<bool> is_done{false};
  std::thread loader([&] {
    while (!is_done) rosbag::Bag();  // each loads one
  });
  for (int i = 0; i < 100; ++i) EXPECT_EQ(BagReader(folder / "x.bag").topics().size(), 1u);
  is_done = true;
  loader.join();
}

TEST_F(BagFile, WithoutTheInputsIsToldWithWhatIsMissingAndWhatIsThere) {
  BagMaker(folder / "none.bag").addRobot("any");
  BagMaker(folder / "empty.bag");
  const auto message = messageOf([&] { find("none.bag"); });
  EXPECT_TRUE(contains(message, "'odom' (nav_msgs/Odometry)")) << message;
  EXPECT_TRUE(contains(message, "'observations' (slam_msgs/LandmarkObservationArray)")) << message;
  EXPECT_TRUE(contains(message, "it has /robot (std_msgs/String, 1 message)")) << message;
  EXPECT_TRUE(contains(messageOf([&] { find("empty.bag"); }), "it has no topic"));
}

TEST_F(BagFile, WithMotionLeavesOdometryOutAndSaysSo) {
  BagMaker(folder / "x.bag")
      .addOdometry()
      .addObservations()
      .add("/motion", 0, test::motion(0, 1, 0));
  const auto inputs = find("x.bag");
  EXPECT_EQ(inputs.topicsOf("motion"), test::Topics{"/motion"});
  EXPECT_EQ(inputs.topicsOf("odom"), test::Topics{});
  EXPECT_TRUE(inputs.isLeftOut("odometry"));
  ASSERT_EQ(inputs.notes().size(), 1u);
  EXPECT_TRUE(contains(inputs.notes()[0],
                       "the bag carries motion: the odometry component is left "
                       "out"))
      << inputs.notes()[0];
}

TEST_F(BagFile, WithOdometryOnlyAsTransformGivesEachStampOnce) {
  BagMaker(folder / "x.bag")
      .addObservations()
      .add("/tf", 0, test::transform("map", "odom", 0))
      .add("/tf", 1, test::transform("/odom", "/base_link", 1))
      .add("/tf", 1, test::transform("odom", "base_link", 1))
      .add("/tf", 2, test::transform("odom", "base_link", 2));
  const auto inputs = find("x.bag");
  EXPECT_EQ(inputs.topicsOf("odom"), test::Topics{"/tf"});
  std::vector<double> positions;
  const auto sinks = test::sinksFor<slam::OdometrySample>(
      [&](const auto& sample) { positions.push_back(sample.pose->x()); });
  BagReader(folder / "x.bag").read(inputs.readers([&](const auto&) { return sinks; }));
  EXPECT_EQ(positions, (std::vector<double>{1, 2}));
}

TEST_F(BagFile, WithOtherTransformsOnlyHasNoOdometry) {
  BagMaker(folder / "x.bag").addObservations().add("/tf", 0, test::transform("map", "odom", 0));
  EXPECT_TRUE(contains(messageOf([&] { find("x.bag"); }), "odom -> base_link in /tf"));
}

TEST(BagTransforms, AnEdgeThatTheProductPublishesIsLeftOut) {
  auto both = test::transform("/odom", "base_link", 1);
  both.transforms.push_back(test::transform("base_link", "arm", 2).transforms[0]);
  const auto kept = withoutEdge(both, "odom", "base_link");
  ASSERT_EQ(kept.transforms.size(), 1u);
  EXPECT_EQ(kept.transforms[0].child_frame_id, "arm");
}

TEST_F(BagFile, GivesStaticTransformsButThoseOfTheMap) {
  BagMaker(folder / "x.bag")
      .add("/tf_static", 0, test::transform("base_link", "camera", 1))
      .add("/tf_static", 1, test::transform("base_link", "camera", 2))
      .add("/tf_static", 2, test::transform("map", "odom", 0));
  const auto all = staticTransforms(BagReader(folder / "x.bag"), "map");
  ASSERT_EQ(all.transforms.size(), 1u);
  EXPECT_EQ(all.transforms[0].transform.translation.x, 2);
}

}  // namespace
}  // namespace slam_ros
