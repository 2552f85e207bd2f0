// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <slam_msgs/LandmarkMap.h>
#include <slam_msgs/LandmarkObservationArray.h>
#include <std_msgs/String.h>
#include <sys/stat.h>
#include <tf2_msgs/TFMessage.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "bag_contents.hpp"
#include "carmen_maker.hpp"
#include "mrclam_set.hpp"
#include "program.hpp"
#include "rawlog_maker.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

/// The content of a file as it is without compression.
std::string unpacked(const std::string& path) {
  std::string content;
  gzFile file = gzopen(path.c_str(), "rb");
  char block[4096];
  for (int count = 0; (count = gzread(file, block, sizeof(block))) > 0;)
    content.append(block, static_cast<std::size_t>(count));
  gzclose(file);
  return content;
}

class SlamImport : public testing::Test {
 protected:
  /// The program ends with this code and one sentence that holds the text, and leaves no bag.
  void expectFailure(const std::string& arguments, int code, const std::string& text) {
    const ProgramRun run = runSlamImport(arguments);
    EXPECT_EQ(run.exit_code, code) << arguments;
    EXPECT_NE(run.output.find(text), std::string::npos) << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
    EXPECT_EQ(out_.count(), 0);
  }

  std::string bag() const { return out_.file("a.bag"); }

  TempFolder in_;
  TempFolder out_;
};

TEST_F(SlamImport, TurnsAnMrclamRobotIntoABag) {
  writeMrclamSet(in_);
  const ProgramRun run = runSlamImport("mrclam " + in_.path() + " --robot 2 " + bag());
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("2 readings of other robots, 1 of unknown"), std::string::npos);
  EXPECT_EQ(out_.count(), 1);
  EXPECT_EQ(messagesOf<std_msgs::String>(bag(), "/robot").at(0).data, "mrclam");

  const auto odometry = messagesOf<nav_msgs::Odometry>(bag(), "/odom");
  ASSERT_EQ(odometry.size(), 4u);
  EXPECT_EQ(odometry[0].header.frame_id, "odom");
  EXPECT_EQ(odometry[0].child_frame_id, "base_link");
  EXPECT_EQ(odometry[0].pose.covariance[0], -1.0);
  EXPECT_EQ(odometry[0].pose.pose.orientation.w, 1.0);
  EXPECT_EQ(odometry[0].twist.twist.linear.x, 0.1);
  EXPECT_EQ(odometry[0].twist.twist.angular.z, -0.4);

  const auto arrays = messagesOf<slam_msgs::LandmarkObservationArray>(bag(), "/observations");
  ASSERT_EQ(arrays.size(), 3u);
  EXPECT_EQ(arrays[2].sequence, 2u);
  EXPECT_TRUE(arrays[1].observations.empty());
  EXPECT_EQ(arrays[0].observations.at(0).covariance[0], -1.0);

  const auto maps = messagesOf<slam_msgs::LandmarkMap>(bag(), "/ground_truth/landmarks");
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_EQ(maps[0].header.frame_id, "world");
  EXPECT_EQ(maps[0].landmarks.at(1).id, 7);
}

TEST_F(SlamImport, TurnsARawlogWithItsTruthIntoABag) {
  {
    RawlogMaker maker(in_.file("a.rawlog"));
    maker.frame(100.0);
    maker.action(1.0, 0.0, 0.0);
    maker.frame(101.0);
  }
  in_.write("a_ground_truth.txt", "1 2 0 5 0 0 7\n");
  in_.write("other_path.txt", "0 0 0 0 0 0\n1 0 0 0.5 0 0\n");
  const ProgramRun run = runSlamImport("rawlog " + in_.file("a.rawlog") + " " + bag() +
                                       " --truth-path " + in_.file("other_path.txt"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(messagesOf<std_msgs::String>(bag(), "/robot").at(0).data, "mrpt_demo");
  EXPECT_EQ(messagesOf<nav_msgs::Odometry>(bag(), "/odom").size(), 2u);
  const auto arrays = messagesOf<slam_msgs::LandmarkObservationArray>(bag(), "/observations");
  ASSERT_EQ(arrays.size(), 2u);
  EXPECT_NEAR(arrays[0].observations.at(0).covariance[0], 0.01, 1e-8);
  const auto poses = messagesOf<geometry_msgs::PoseStamped>(bag(), "/ground_truth/pose");
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[1].header.stamp, arrays[1].header.stamp);
  EXPECT_EQ(poses[1].pose.position.x, 1.0);
  EXPECT_EQ(messagesOf<slam_msgs::LandmarkMap>(bag(), "/ground_truth/landmarks").size(), 1u);
}

TEST_F(SlamImport, TurnsACarmenLogIntoABagWithTheStampsOfItsSource) {
  in_.write("a.clf", flaser("10.0", "0 0 0") + odom("10.1", "0.5 0 0") + flaser("10.2", "1 0 0") +
                         flaser("10.2", "3 0 0") + "FLASER 1\n");
  const ProgramRun run = runSlamImport("carmen " + in_.file("a.clf") + " " + bag());
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("3 scans (FLASER) of 180 beams"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("1 stand twice; 0 gaps"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("1 jumps"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("Bad lines left out: 1; the first: "), std::string::npos);
  EXPECT_EQ(messagesOf<std_msgs::String>(bag(), "/robot").at(0).data, "carmen");

  const auto scans = messagesOf<sensor_msgs::LaserScan>(bag(), "/scan");
  const auto odometry = messagesOf<nav_msgs::Odometry>(bag(), "/odom");
  ASSERT_EQ(scans.size(), 3u);
  ASSERT_EQ(odometry.size(), 4u);
  EXPECT_EQ(odometry[1].pose.pose.position.x, 0.5);
  EXPECT_EQ(odometry[1].twist.twist.linear.x, 0.3);
  EXPECT_EQ(odometry[3].header.stamp, scans[2].header.stamp);
  EXPECT_GT(scans[2].header.stamp, scans[1].header.stamp);
  EXPECT_NEAR(scans[0].angle_max, 89.0 * M_PI / 180.0, 1e-6);
  EXPECT_EQ(scans[0].range_max, 80.0f);

  const auto mounts = messagesOf<tf2_msgs::TFMessage>(bag(), "/tf_static");
  ASSERT_EQ(mounts.size(), 1u);
  EXPECT_EQ(mounts[0].transforms.at(0).header.frame_id, "base_link");
  EXPECT_EQ(mounts[0].transforms.at(0).child_frame_id, scans[0].header.frame_id);
  std::ifstream table(bag() + ".stamps.csv");
  const std::string text(std::istreambuf_iterator<char>(table), {});
  EXPECT_NE(text.find("\n10.200000000,10.200100000\n"), std::string::npos) << text;
}

TEST_F(SlamImport, TurnsARawlogOfALaserIntoABag) {
  {
    RawlogMaker maker(in_.file("a.rawlog"));
    maker.frame({RawlogMaker::scan(100.0), RawlogMaker::scan(100.01, "rear", M_PI)});
    maker.action(1.0, 0.0, 0.0);
    maker.frame({RawlogMaker::scan(101.0)});
  }
  const ProgramRun run = runSlamImport("rawlog " + in_.file("a.rawlog") + " " + bag());
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("2 scans, 1 of the laser 'rear' left out"), std::string::npos)
      << run.output;
  EXPECT_EQ(messagesOf<std_msgs::String>(bag(), "/robot").at(0).data, "sena");
  const auto scans = messagesOf<sensor_msgs::LaserScan>(bag(), "/scan");
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_EQ(scans[1].ranges.size(), 3u);
  EXPECT_NEAR(scans[1].angle_max, M_PI / 2.0, 1e-6);
  const auto mounts = messagesOf<tf2_msgs::TFMessage>(bag(), "/tf_static");
  ASSERT_EQ(mounts.size(), 1u);
  EXPECT_EQ(mounts[0].transforms.at(0).child_frame_id, scans[0].header.frame_id);
  EXPECT_NEAR(mounts[0].transforms[0].transform.translation.x, 0.5, 1e-9);
  EXPECT_NEAR(mounts[0].transforms[0].transform.translation.z, 0.3, 1e-9);
}

TEST_F(SlamImport, SaysThatThereIsNoTruth) {
  {
    RawlogMaker maker(in_.file("a.rawlog"));
    maker.action(1.0, 0.0, 0.0);
    maker.frame(101.0);
  }
  const ProgramRun run = runSlamImport("rawlog " + in_.file("a.rawlog") + " " + bag());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.output.find("No true landmarks"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("No true path"), std::string::npos) << run.output;
}

TEST_F(SlamImport, WritesTheSameBytesTwice) {
  writeMrclamSet(in_);
  const auto content = [this](const std::string& name) {
    runSlamImport("mrclam " + in_.path() + " --robot 2 " + out_.file(name));
    std::ifstream file(out_.file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string first = content("a.bag");
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, content("b.bag"));
}

TEST_F(SlamImport, RefusesWrongUseWithCodeTwo) {
  writeMrclamSet(in_);
  EXPECT_EQ(runSlamImport("").exit_code, 2);
  expectFailure("nonsense x y", 2, "'nonsense'; the formats are: carmen, circles, mrclam, rawlog");
  expectFailure("mrclan x y", 2, "did you mean 'mrclam'?");
  EXPECT_EQ(runSlamImport("mrclam " + in_.path() + " " + bag()).exit_code, 2);
  EXPECT_EQ(runSlamImport("--help").exit_code, 0);
  expectFailure("mrclam " + in_.path() + " --robot 3 " + bag(), 2, "has no robot 3; it has 2");
  expectFailure("mrclam " + in_.file("none") + " --robot 2 " + bag(), 2, "there is no folder");
  expectFailure("rawlog " + in_.file("none") + " " + bag(), 2, "there is no file");
  expectFailure("carmen " + in_.file("none") + " " + bag(), 2, "there is no file");
  expectFailure("mrclam " + in_.path() + " --robot 2 " + out_.file("none/a.bag"), 2,
                "there is no folder");
}

TEST_F(SlamImport, RefusesBadFilesWithCodeOne) {
  in_.write("a.clf", "ODOM 1 2 3\n");
  expectFailure("carmen " + in_.file("a.clf") + " " + bag(), 1, "holds no laser scans");
  in_.write("a.rawlog", "no rawlog");
  expectFailure("rawlog " + in_.file("a.rawlog") + " " + bag(), 1, "is no MRPT rawlog");
  expectFailure("mrclam " + in_.path() + " --robot 2 " + bag(), 1, "it has no Barcodes.dat");
  writeMrclamSet(in_);
  in_.write("Robot2_Measurement.dat", "1248444187.180 63 2.5 0.1\n1248444187.180 63 2.5\n");
  expectFailure("mrclam " + in_.path() + " --robot 2 " + bag(), 1, "Robot2_Measurement.dat:2:");
}

TEST_F(SlamImport, LeavesNothingWhenTheDiskIsFull) {
  writeMrclamSet(in_);
  const ProgramRun run = runSlamImport("mrclam " + in_.path() + " --robot 2 " + bag(), 1);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("cannot write " + bag()), std::string::npos) << run.output;
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  EXPECT_EQ(out_.count(), 0);
}

TEST_F(SlamImport, NeverReplacesADevice) {
  writeMrclamSet(in_);
  expectFailure("mrclam " + in_.path() + " --robot 2 /dev/null", 2, "it is no ordinary file");
}

/// MRPT's library crashes with some of these, and asks for gigabytes with others.
TEST_F(SlamImport, ADamagedRawlogIsToldWhateverTheLibraryMakesOfIt) {
  {
    RawlogMaker maker(in_.file("a.rawlog"));
    for (int i = 1; i < 10; ++i) {
      maker.action(0.1, 0.0, 0.0);
      maker.frame(i);
      maker.frame({RawlogMaker::scan(i + 0.5)});
    }
  }
  const auto content = unpacked(in_.file("a.rawlog"));
  for (std::size_t at = 0; at + 4 < content.size(); at += 1 + content.size() / 50) {
    auto damaged = content;
    damaged.replace(at, 4, at % 2 == 0 ? "\xff\xff\xff\x7f" : "\xff\xff\xff\xff");
    in_.write("b.rawlog", damaged);
    const auto run = runSlamImport("rawlog " + in_.file("b.rawlog") + " " + bag());
    EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 1) << at << ": " << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << at << run.output;
  }
}

TEST_F(SlamImport, ReadsNoPipe) {
  ASSERT_EQ(::mkfifo(in_.file("pipe").c_str(), 0600), 0);
  for (const std::string format : {"rawlog", "carmen"})
    expectFailure(format + " " + in_.file("pipe") + " " + bag(), 2, "is a named pipe");
  expectFailure("circles " + in_.file("pipe") + " " + bag(), 1, "is a named pipe");
}

}  // namespace
}  // namespace slam::eval
