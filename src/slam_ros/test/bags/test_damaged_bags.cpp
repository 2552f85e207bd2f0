// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <map>

#include "bag_maker.hpp"
#include "slam_core/common/random.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/offline_run.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::messageOf;

/// A bag is read whole, or it is told in one sentence why it is not. Nothing crashes.
class DamagedBag : public ::testing::Test {
 protected:
  DamagedBag() {
    BagMaker(folder / "x.bag")
        .addOdometry()
        .addObservations()
        .addTruth()
        .add("/tf", 1, test::transform("odom", "base_link", 1))
        .addRobot("test");
    content = folder.read("x.bag");
  }

  std::string faultOfReading(const std::string& damaged) const {
    folder.write("damaged.bag", damaged);
    return messageOf([&] {
      const BagReader bag(folder / "damaged.bag");
      const auto ignore = [](const auto&) {};
      bag.read({{"/odom", onMessage<nav_msgs::Odometry>(ignore)},
                {"/observations", onMessage<slam_msgs::LandmarkObservationArray>(ignore)}});
      bag.robot();
      bag.read({{"/tf", onMessage<tf2_msgs::TFMessage>(ignore)}});
    });
  }
  void expectOneSentence(const std::string& fault, const std::string& damage) const {
    if (fault.empty()) return;
    EXPECT_TRUE(contains(fault, "cannot read the bag " + (folder / "damaged.bag") + ": "))
        << damage << ": " << fault;
    EXPECT_FALSE(contains(fault, "\n")) << damage << ": " << fault;
  }

  test::Folder folder;
  std::string content;
};

TEST_F(DamagedBag, CutOffIsTold) {
  for (std::size_t size = 0; size < content.size(); size += content.size() / 40) {
    const auto fault = faultOfReading(content.substr(0, size));
    EXPECT_NE(fault, "") << size;
    expectOneSentence(fault, "cut off at " + std::to_string(size));
  }
}

TEST_F(DamagedBag, WithZeroesIsTold) {
  for (std::size_t at = 0; at + 512 < content.size(); at += content.size() / 40) {
    auto damaged = content;
    damaged.replace(at, 512, 512, '\0');
    expectOneSentence(faultOfReading(damaged), "zeroes at " + std::to_string(at));
  }
}

TEST_F(DamagedBag, WithBytesOfChanceIsTold) {
  slam::RandomStream random(1, 0);
  std::size_t told = 0;
  for (int trial = 0; trial < 120; ++trial) {
    auto damaged = content;
    const auto chance = [&](std::size_t most) {
      return static_cast<std::size_t>(random.uniform() * static_cast<double>(most));
    };
    for (std::size_t i = 0, last = 1 + chance(20); i < last; ++i)
      damaged[chance(damaged.size())] = static_cast<char>(chance(256));
    const auto fault = faultOfReading(damaged);
    expectOneSentence(fault, "trial " + std::to_string(trial));
    told += fault.empty() ? 0 : 1;
  }
  EXPECT_GT(told, 20u) << "else nothing was damaged";
}

/// The library would ask for all that a length tells, and follow a place out of its buffer.
TEST_F(DamagedBag, WithLengthsAndPlacesOutOfAllBoundsIsTold) {
  const std::string huge = "\xf0\xff\xff\x7f";
  for (const char* field :
       {"op=\x03", "op=\x04", "op=\x05", "op=\x06", "op=\x07", "count=", "size="})
    for (auto at = content.find(field); at != std::string::npos; at = content.find(field, at + 1))
      for (const std::ptrdiff_t offset : {-8, -4, 5, 9, 13}) {
        auto damaged = content;
        const auto begin = static_cast<std::ptrdiff_t>(at) + offset;
        if (begin < 0 || begin + 4 > static_cast<std::ptrdiff_t>(damaged.size())) continue;
        damaged.replace(static_cast<std::size_t>(begin), 4, huge);
        expectOneSentence(faultOfReading(damaged), std::string(field) + std::to_string(offset));
      }
}

TEST_F(DamagedBag, AListLongerThanItsMessageIsNotMadeRoomFor) {
  slam_msgs::LandmarkObservationArray array;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(array), 0);
  for (std::size_t i = bytes.size() - 4; i < bytes.size(); ++i) bytes[i] = 0xff;  // its length
  const auto handler = onMessage<slam_msgs::LandmarkObservationArray>([](const auto&) {});
  const std::string topic = "/observations";
  EXPECT_THROW(handler({topic, ros::Time(), bytes}), ros::serialization::StreamOverrunException);
}

TEST_F(DamagedBag, LeavesTheRunThatItsMapCameFrom) {
  const auto product = folder.write("p.yaml", "version: 1\nproduct: test\nbackend: ekf\n");
  const auto robot = folder.write("r.yaml", "version: 1\nrobot: test\n");
  OfflineOptions options{
      {product, robot, folder / "x.bag", folder / "run", {}, {}}, {}, {}, {}, {}};
  ASSERT_EQ(messageOf([&] { OfflineRun(options).run(); }), "");
  folder.write("run/report.html", "of the evaluation");
  std::map<std::string, std::string> before;
  for (const auto* name : {"trajectory.tum", "landmarks.yaml", "config.yaml", "metrics.json",
                           "report.html", "ground_truth.tum", "updates.csv", "odometry.tum"})
    EXPECT_NE(before[name] = folder.read(std::string("run/") + name), "") << name;
  auto damaged = content;
  damaged.replace(content.size() / 3, 2000, 2000, '\xff');
  options.bag = folder.write("damaged.bag", damaged);
  options.load_map = folder / "run";
  EXPECT_NE(messageOf([&] { OfflineRun(options).run(); }), "");
  for (const auto& [name, text] : before) EXPECT_EQ(folder.read("run/" + name), text) << name;
}

}  // namespace
}  // namespace slam_ros
