// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "recording.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <slam_msgs/LandmarkMap.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_sim/world_file.hpp"

namespace slam::sim {
namespace {

std::string folder() { return SLAM_SIM_FOLDER; }

class RecordingOfTheOffice : public testing::Test {
 protected:
  /// The first moments of the office, with a small camera.
  std::string record(const std::string& name, RecordingOptions options) {
    auto robot = readRobotFile(folder() + "/robots/segway.yaml");
    robot.cameras[0].optics.samples = 2;
    robot.cameras[1].optics.samples = 2;
    if (options.duration == 0.0) options.duration = 0.3;
    Recording recording(readWorldFile(folder() + "/worlds/office.yaml"), robot, options);
    std::ostringstream log;
    Progress progress(log, false);
    recording.write(files_ / name, progress, stop_);
    return files_ / name;
  }

  template <class Message>
  static std::vector<typename Message::Ptr> messages(const std::string& path,
                                                     const std::string& topic) {
    rosbag::Bag bag(path);
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    std::vector<typename Message::Ptr> all;
    for (const auto& instance : view) all.push_back(instance.instantiate<Message>());
    return all;
  }

  test::TemporaryFolder files_;
  std::atomic<bool> stop_{false};
};

TEST_F(RecordingOfTheOffice, GivesTheSameBytesForTheSameSeedAndAnyNumberOfThreads) {
  const auto once = test::contentOf(record("once.bag", {1, {}, 0.3, 1}));
  const auto again = test::contentOf(record("again.bag", {1, {}, 0.3, 3}));
  EXPECT_GT(once.size(), 10000u);
  EXPECT_TRUE(once == again);
}

TEST_F(RecordingOfTheOffice, GivesOtherNoiseForAnotherSeed) {
  const auto one = record("one.bag", {1, {"odom", "scan"}, 2.0, 1});
  const auto two = record("two.bag", {2, {"odom", "scan"}, 2.0, 1});
  const auto a = messages<nav_msgs::Odometry>(one, "/odom");
  const auto b = messages<nav_msgs::Odometry>(two, "/odom");
  ASSERT_EQ(a.size(), b.size());
  EXPECT_NE(a.back()->pose.pose.position.x, b.back()->pose.pose.position.x);
  EXPECT_NE(messages<sensor_msgs::LaserScan>(one, "/scan")[0]->ranges,
            messages<sensor_msgs::LaserScan>(two, "/scan")[0]->ranges);
  const auto truth_a = messages<geometry_msgs::PoseStamped>(one, "/ground_truth/pose");
  const auto truth_b = messages<geometry_msgs::PoseStamped>(two, "/ground_truth/pose");
  EXPECT_EQ(truth_a.back()->pose.position.x, truth_b.back()->pose.position.x);
}

TEST_F(RecordingOfTheOffice, HoldsEveryStreamAtItsRateWithStampsAsReceiveTimes) {
  const auto path = record("all.bag", {1, {}, 1.0, 2});
  rosbag::Bag bag(path);
  rosbag::View view(bag);
  std::map<std::string, int> counts;
  std::vector<std::string> order;
  for (const auto& instance : view) {
    ++counts[instance.getTopic()];
    order.push_back(instance.getTopic());
    if (const auto odometry = instance.instantiate<nav_msgs::Odometry>()) {
      EXPECT_EQ(odometry->header.stamp, instance.getTime());
    }
  }
  EXPECT_EQ(counts["/odom"], 51);
  EXPECT_EQ(counts["/tf"], 51);
  EXPECT_EQ(counts["/ground_truth/pose"], 51);
  EXPECT_EQ(counts["/scan"], 10);
  EXPECT_EQ(counts["/camera/image_raw/compressed"], 10);
  EXPECT_EQ(counts["/camera/camera_info"], 11);
  EXPECT_EQ(counts["/ceiling_camera/image_raw/compressed"], 15);
  EXPECT_EQ(counts["/ceiling_camera/camera_info"], 16);
  ASSERT_GE(order.size(), 5u);
  EXPECT_EQ(order[0], "/robot");
  EXPECT_EQ(order[1], "/ground_truth/landmarks");
  EXPECT_EQ(order[2], "/tf_static");
}

TEST_F(RecordingOfTheOffice, HoldsOnlyTheStreamsThatAreWanted) {
  const auto path = record("some.bag", {1, {"scan"}, 1.0, 1});
  EXPECT_EQ(messages<nav_msgs::Odometry>(path, "/odom").size(), 0u);
  EXPECT_EQ(messages<sensor_msgs::LaserScan>(path, "/scan").size(), 10u);
  EXPECT_EQ(messages<slam_msgs::LandmarkMap>(path, "/ground_truth/landmarks").size(), 1u);
}

TEST_F(RecordingOfTheOffice, ImagesAreGrayPicturesOfTheCalibratedSize) {
  const auto path = record("image.bag", {1, {"camera"}, 0.1, 1});
  const auto images = messages<sensor_msgs::CompressedImage>(path, "/camera/image_raw/compressed");
  const auto infos = messages<sensor_msgs::CameraInfo>(path, "/camera/camera_info");
  ASSERT_EQ(images.size(), 1u);
  ASSERT_EQ(infos.size(), 2u);
  EXPECT_EQ(images[0]->header.stamp, infos[1]->header.stamp);
  EXPECT_EQ(images[0]->header.frame_id, "camera_optical_frame");
  const cv::Mat pixels = cv::imdecode(images[0]->data, cv::IMREAD_UNCHANGED);
  EXPECT_EQ(pixels.type(), CV_8UC1);
  EXPECT_EQ(pixels.cols, static_cast<int>(infos[0]->width));
  EXPECT_EQ(pixels.rows, static_cast<int>(infos[0]->height));
}

TEST_F(RecordingOfTheOffice, TheMountsLeadFromTheBaseToEverySensor) {
  const auto path = record("mounts.bag", {1, {"odom"}, 0.1, 1});
  const auto mounts = messages<tf2_msgs::TFMessage>(path, "/tf_static");
  ASSERT_EQ(mounts.size(), 1u);
  std::map<std::string, std::string> parents;
  for (const auto& edge : mounts[0]->transforms)
    parents[edge.child_frame_id] = edge.header.frame_id;
  EXPECT_EQ(parents["laser"], "base_link");
  EXPECT_EQ(parents["camera_optical_frame"], "camera_link");
  EXPECT_EQ(parents["camera_link"], "base_link");
  EXPECT_EQ(parents["ceiling_camera_optical_frame"], "ceiling_camera_link");
}

TEST_F(RecordingOfTheOffice, HoldsTheCommandsThatTheBaseFollows) {
  auto robot = readRobotFile(folder() + "/robots/segway.yaml");
  robot.commands->relative_noise = 0.0;
  Recording recording(readWorldFile(folder() + "/worlds/office.yaml"), robot,
                      {1, {"odom", "commands"}, 6.0, 1});
  std::ostringstream log;
  Progress progress(log, false);
  recording.write(files_ / "commands.bag", progress, stop_);
  const auto commands =
      messages<geometry_msgs::TwistStamped>(files_ / "commands.bag", "/cmd_vel_out");
  EXPECT_EQ(commands.size(), 120u);
  EXPECT_NEAR((commands[1]->header.stamp - commands[0]->header.stamp).toSec(), 0.05, 1e-9);
  double way = 0.0, driven = 0.0;
  for (const auto& command : commands)
    way += 0.05 * robot.commands->speed_scale * command->twist.linear.x;
  const auto truth =
      messages<geometry_msgs::PoseStamped>(files_ / "commands.bag", "/ground_truth/pose");
  for (std::size_t i = 1; i < truth.size(); ++i)
    driven += std::hypot(truth[i]->pose.position.x - truth[i - 1]->pose.position.x,
                         truth[i]->pose.position.y - truth[i - 1]->pose.position.y);
  EXPECT_GT(driven, 1.0);
  EXPECT_NEAR(way, driven + robot.commands->time_constant * commands.back()->twist.linear.x, 0.02)
      << "the base is behind its commands";
}

TEST_F(RecordingOfTheOffice, HoldsAnImuWithItsMountWhereTheRobotHasOne) {
  const auto robot = readRobotFile(folder() + "/robots/skid.yaml");
  Recording recording(readWorldFile(folder() + "/worlds/office.yaml"), robot,
                      {1, {"odom", "imu"}, 6.0, 1});
  std::ostringstream log;
  Progress progress(log, false);
  recording.write(files_ / "imu.bag", progress, stop_);
  const auto readings = messages<sensor_msgs::Imu>(files_ / "imu.bag", "/imu");
  const auto truth = messages<geometry_msgs::PoseStamped>(files_ / "imu.bag", "/ground_truth/pose");
  EXPECT_EQ(readings.size(), 600u);
  double turned = 0.0;
  for (const auto& reading : readings) turned -= 0.01 * (reading->angular_velocity.z - 0.009);
  const auto heading = [](const auto& pose) {
    return 2.0 * std::atan2(pose->pose.orientation.z, pose->pose.orientation.w);
  };
  EXPECT_NEAR(turned, std::remainder(heading(truth.back()) - heading(truth.front()), 2.0 * M_PI),
              0.02)
      << "it hangs upside down";
  EXPECT_EQ(readings[0]->orientation_covariance[0], -1.0);
  EXPECT_LT(readings[0]->linear_acceleration.z, -9.0);
  const auto mounts = messages<tf2_msgs::TFMessage>(files_ / "imu.bag", "/tf_static");
  EXPECT_EQ(mounts[0]->transforms[1].child_frame_id, robot.imu->frame);
}

TEST_F(RecordingOfTheOffice, HoldsTheScansOfTwoLasersWithMountsAndStampsOfTheirOwn) {
  const auto robot = readRobotFile(folder() + "/robots/twin.yaml");
  Recording recording(readWorldFile(folder() + "/worlds/office.yaml"), robot, {1, {}, 1.0, 1});
  std::ostringstream log;
  Progress progress(log, false);
  recording.write(files_ / "twin.bag", progress, stop_);
  const auto scans = messages<sensor_msgs::LaserScan>(files_ / "twin.bag", "/scan");
  const auto rear = messages<sensor_msgs::LaserScan>(files_ / "twin.bag", "/rear_scan");
  ASSERT_EQ(scans.size(), 10u);
  ASSERT_EQ(rear.size(), 8u);
  EXPECT_EQ(rear[0]->header.frame_id, "rear_laser");
  EXPECT_NEAR((rear[0]->header.stamp - scans[0]->header.stamp).toSec(), 0.032, 1e-6);
  EXPECT_EQ(rear[0]->ranges.size(), 361u);
  EXPECT_NE(rear[0]->ranges[180], scans[0]->ranges[256]) << "another wall";
  const auto mounts = messages<tf2_msgs::TFMessage>(files_ / "twin.bag", "/tf_static").at(0);
  ASSERT_EQ(mounts->transforms.size(), 2u);
  EXPECT_EQ(mounts->transforms[1].child_frame_id, "rear_laser");
  EXPECT_LT(mounts->transforms[1].transform.translation.x, 0.0);
}

TEST_F(RecordingOfTheOffice, LeavesNothingWhenItIsInterrupted) {
  stop_ = true;
  EXPECT_THROW(record("none.bag", {1, {"odom"}, 1.0, 1}), Interrupted);
  EXPECT_EQ(files_.files(), 0u);
}

/// Exit code and error output of the program.
std::pair<int, std::string> run(const std::string& arguments, const std::string& errors) {
  const auto command = std::string(SLAM_SIM_PROGRAM) + " " + arguments + " 2>" + errors;
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), test::contentOf(errors)};
}

TEST(SlamSimProgram, TellsWrongUseFromAFailureInOneSentenceAndLeavesNoBag) {
  const test::TemporaryFolder files;
  const auto errors = files / "errors.txt", bag = files / "a.bag";
  const auto broken = files.write("broken.yaml", "version: 1\nworld: x\nwals: []\n");
  const struct {
    std::string arguments, sentence;
    int code;
  } cases[] = {{"", "OUT.bag is required", 2},
               {bag + " --wrold office", "did you mean '--world'?", 2},
               {bag + " --world ofice", "did you mean 'office'?", 2},
               {bag + " --robot segwy", "did you mean 'segway'?", 2},
               {bag + " --only odm", "did you mean 'odom'?", 2},
               {bag + " --duration -1", "--duration", 2},
               {bag + " --seed x", "--seed", 2},
               {files / "none/a.bag --only odom", "there is no folder", 2},
               {bag + " --world " + broken, "wals is unknown (did you mean 'walls'?)", 1},
               {bag + " --world " + (files / "none.yaml"), "does it exist?", 1}};
  for (const auto& [arguments, sentence, code] : cases) {
    const auto [exit_code, said] = run(arguments, errors);
    EXPECT_EQ(exit_code, code) << arguments;
    EXPECT_NE(said.find(sentence), std::string::npos) << arguments << ": " << said;
  }
  EXPECT_EQ(files.files(), 2u);
}

}  // namespace
}  // namespace slam::sim
