// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sensor_msgs/Imu.h>

#include <cmath>

#include "bag_maker.hpp"
#include "found_inputs.hpp"
#include "slam_core/imu/imu_reading.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::findInputs;
using test::messageOf;
using test::Topics;

sensor_msgs::Imu readingAt(double t) {
  sensor_msgs::Imu message;
  message.header.stamp = test::at(t);
  message.header.frame_id = "imu_link";
  message.angular_velocity.z = 0.01;
  return message;
}

struct ImuBags : ::testing::Test {
  /// A bag of four seconds with odometry, landmarks and what `fill` adds.
  template <class Fill>
  std::string bag(Fill fill) {
    BagMaker maker(folder / "x.bag");
    maker.addOdometry().addObservations();
    fill(maker);
    return folder / "x.bag";
  }
  static slam::ProductConfig product() {
    slam::ProductConfig product;
    product.odometry = "wheel_imu";
    product.detector = "none";
    return product;
  }
  /// @return the exit status of a run; its output is in the file `stdout`
  int run(const std::string& bag) {
    const auto product = folder.write("product.yaml",
                                      "{version: 1, product: test, backend: ekf, odometry: "
                                      "wheel_imu, detector: none}");
    const auto command = std::string(SLAM_OFFLINE) + " " + product + " --robot " +
                         folder.write("robot.yaml", "{version: 1, robot: test}") + " --bag " + bag +
                         " --out " + (folder / "run") + " > " + (folder / "stdout") + " 2>&1";
    return std::system(command.c_str());
  }
  test::Folder folder;
};

TEST_F(ImuBags, TheOnlyImuThereIsIsFoundWhateverItsTopic) {
  const BagReader reader(bag([](auto& maker) { maker.add("/imu/data", 1, readingAt(1)); }));
  const auto inputs = findInputs(reader, product());
  EXPECT_EQ(inputs.topicsOf("imu"), Topics{"/imu/data"});
  double rate = 0.0;
  const auto sinks = test::sinksFor<slam::ImuReading>(
      [&](const auto& reading) { rate += reading.angular_velocity.z(); });
  reader.read(inputs.readers([&](const auto&) { return sinks; }));
  EXPECT_EQ(rate, 0.01);
}

TEST_F(ImuBags, SaysThatTheImuIsMissing) {
  const BagReader reader(bag([](auto&) {}));
  const auto message = messageOf([&] { findInputs(reader, product()); });
  EXPECT_TRUE(contains(message, "lacks an IMU's angular velocities: 'imu' (sensor_msgs/Imu)"))
      << message;
}

TEST_F(ImuBags, ARunWithoutAMountGoesOnAndSaysWhatIsMissing) {
  const auto path = bag([](auto& maker) {
    for (int i = 0; i < 400; ++i) maker.add("/imu", 0.01 * i, readingAt(0.01 * i));
  });
  EXPECT_EQ(run(path), 0) << folder.read("stdout");
  EXPECT_TRUE(contains(folder.read("stdout"), "how the IMU of frame 'imu_link' is mounted"));
  EXPECT_TRUE(contains(folder.read("stdout"), "the wheels' heading is used meanwhile"));
  EXPECT_TRUE(contains(folder.read("stdout"), "imu_no_mount 400")) << folder.read("stdout");
}

TEST_F(ImuBags, ARunGoesOnWhereReadingsAreDamagedOrCeaseToCome) {
  const auto path = bag([](auto& maker) {
    maker.add("/tf_static", 0, test::transform("base_link", "imu_link", 0));
    for (int i = 0; i < 200; ++i) {
      auto reading = readingAt(0.01 * i);
      if (i % 50 == 0) reading.angular_velocity.z = std::nan("");
      maker.add("/imu", 0.01 * i, reading);
    }
  });
  EXPECT_EQ(run(path), 0) << folder.read("stdout");
  EXPECT_TRUE(contains(folder.read("stdout"), "the IMU is silent")) << folder.read("stdout");
  EXPECT_TRUE(contains(folder.read("stdout"), "its angular velocity is not a number"));
}

}  // namespace
}  // namespace slam_ros
