// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <geometry_msgs/Twist.h>
#include <geometry_msgs/TwistStamped.h>
#include <gtest/gtest.h>

#include <vector>

#include "bag_maker.hpp"
#include "found_inputs.hpp"
#include "slam_core/models/velocity_command.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::findInputs;
using test::messageOf;
using test::Topics;

geometry_msgs::TwistStamped commandAt(double t) {
  geometry_msgs::TwistStamped message;
  message.header.stamp = test::at(t);
  message.twist.linear.x = 1.0;
  message.twist.linear.y = 0.2;
  message.twist.angular.z = -0.5;
  return message;
}

slam::ProductConfig product() {
  slam::ProductConfig product;
  product.odometry = "command";
  product.detector = "none";
  return product;
}

struct CommandBags : ::testing::Test {
  test::Folder folder;
};

TEST_F(CommandBags, TheOnlyStampedTwistThereIsIsFoundWhateverItsTopic) {
  BagMaker(folder / "x.bag").addObservations().add("/base/cmd_vel_out", 1, commandAt(1));
  const BagReader reader(folder / "x.bag");
  const auto inputs = findInputs(reader, product());
  EXPECT_EQ(inputs.topicsOf("commands"), Topics{"/base/cmd_vel_out"});
  std::vector<slam::VelocityCommand> taken;
  const auto sinks =
      test::sinksFor<slam::VelocityCommand>([&](const auto& command) { taken.push_back(command); });
  reader.read(inputs.readers([&](const auto&) { return sinks; }));
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_EQ(taken[0].twist, Eigen::Vector3d(1.0, 0.2, -0.5));
  EXPECT_EQ(taken[0].stamp, fromRos(test::at(1)));
}

TEST_F(CommandBags, SaysThatATwistHasNoStamp) {
  BagMaker(folder / "x.bag").addObservations().add("/cmd_vel", 1, geometry_msgs::Twist());
  const BagReader reader(folder / "x.bag");
  const auto message = messageOf([&] { findInputs(reader, product()); });
  EXPECT_TRUE(contains(message,
                       "lacks commands: 'cmd_vel_out' (geometry_msgs/TwistStamped); a "
                       "geometry_msgs/Twist has no stamp"))
      << message;
}

TEST_F(CommandBags, ARobotDrivesByItsCommandsAlone) {
  {
    BagMaker maker(folder / "x.bag");
    maker.addObservations();  // of a robot that drives ahead at 1 m/s
    for (int i = 0; i < 80; ++i) {
      auto command = commandAt(0.05 * i);
      command.twist.linear.y = command.twist.angular.z = 0.0;
      maker.add("/cmd_vel_out", 0.05 * i, command);
    }
  }
  const auto run = std::string(SLAM_OFFLINE) + " " +
                   folder.write("product.yaml",
                                "{version: 1, product: test, backend: ekf, odometry: command, "
                                "detector: none}") +
                   " --robot " + folder.write("robot.yaml", "{version: 1, robot: test}") +
                   " --bag " + (folder / "x.bag") + " --out " + (folder / "run") + " > " +
                   (folder / "stdout") + " 2>&1";
  ASSERT_EQ(std::system(run.c_str()), 0) << folder.read("stdout");
  EXPECT_TRUE(contains(folder.read("run/trajectory.tum"), "103.400000000 3."))
      << folder.read("run/trajectory.tum");
}

}  // namespace
}  // namespace slam_ros
