// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "bag_maker.hpp"
#include "slam_ros/tune_run.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;

struct Tune : ::testing::Test {
  Tune() {
    product = folder.write("product.yaml", "version: 1\nproduct: test\nbackend: ekf\n");
    robot = folder.write("robot.yaml",
                         "# My robot.\nversion: 1\nrobot: test\nwheel_odometry:\n  alpha1: 0.01\n"
                         "landmark_sensor:\n  sigma_range: 0.3  # [m]\n");
  }
  /// The exit code; what it printed stands in the files stdout and stderr.
  int tune(const std::string& bag, const std::string& more = "") const {
    const auto out = contains(more, "--out ") ? "" : " --out " + (folder / "tuned.yaml");
    const auto command = std::string(SLAM_TUNE) + " " + robot + " --bag " + (folder / bag) +
                         " --product " + product + out + " " + more + " > " + (folder / "stdout") +
                         " 2> " + (folder / "stderr");
    return WEXITSTATUS(std::system(command.c_str()));
  }
  /// A robot that stands; ranges and bearings err by a known amount, without covariances.
  void makeStanding(const std::string& name) const {
    BagMaker bag(folder / name);
    for (int i = 0; i < 200; ++i) {
      auto odometry = test::odometry(0.1 * i);
      odometry.pose.pose.position.x = 0.0;
      bag.add("/odom", 0.1 * i, odometry);
      auto seen = test::observations(0.0, static_cast<std::uint64_t>(i));
      seen.header.stamp = odometry.header.stamp;
      for (std::size_t k = 0; k < 2; ++k) {
        auto& z = seen.observations[k];
        z.covariance = {-1, 0, 0, -1};
        z.range += (i + k) % 2 == 0 ? 0.1 : -0.1;
        z.bearing += i % 4 < 2 ? 0.02 : -0.02;
      }
      bag.add("/observations", 0.1 * i, seen);
    }
  }
  test::Folder folder;
  std::string product, robot;
};

TEST_F(Tune, OfARobotThatStandsFindsTheSensorsSigmasAndSaysWhatCannotBeSeen) {
  makeStanding("standing.bag");
  ASSERT_EQ(tune("standing.bag"), 0) << folder.read("stderr");
  const auto printed = folder.read("stdout"), file = folder.read("tuned.yaml");
  EXPECT_TRUE(contains(printed, "cannot be seen: the robot drives no more than")) << printed;
  EXPECT_TRUE(contains(printed, "cannot be seen: the robot turns no more than")) << printed;
  EXPECT_TRUE(contains(file, "# My robot.")) << file;
  EXPECT_TRUE(contains(file, "standing.bag")) << file;
  EXPECT_TRUE(contains(file, "  alpha1: 0.01\n")) << file;
  EXPECT_TRUE(contains(file, "  sigma_range: 0.1")) << file;
  EXPECT_TRUE(contains(file, "  sigma_bearing: 0.02")) << file;
}

TEST_F(Tune, OfABagWithoutObservationsFailsAndLeavesTheFileAlone) {
  folder.write("tuned.yaml", "what was there");
  BagMaker(folder / "blind.bag").addOdometry();
  EXPECT_EQ(tune("blind.bag"), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "observations")) << folder.read("stderr");
  {
    BagMaker empty(folder / "empty.bag");
    empty.addOdometry();
    auto nothing = test::observations(0.2, 0);
    nothing.observations.clear();
    empty.add("/observations", 0.2, nothing);
  }
  EXPECT_EQ(tune("empty.bag"), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "holds no observations of landmarks with an id"))
      << folder.read("stderr");
  EXPECT_EQ(folder.read("tuned.yaml"), "what was there");
}

TEST_F(Tune, WithNothingToLearnSaysWhyAndWritesNoFile) {
  BagMaker(folder / "x.bag").addOdometry().addObservations();
  EXPECT_EQ(tune("x.bag", "--parameter landmark_sensor.sigma_range"), 1);
  EXPECT_EQ(folder.read("stderr"),
            "slam_tune: nothing can be tuned on x.bag, which does not show "
            "landmark_sensor.sigma_range (every observation brings its own covariance); no file "
            "was written\n");
  EXPECT_EQ(folder.read("stdout"), "");
  EXPECT_FALSE(folder.has("tuned.yaml"));
  makeStanding("standing.bag");
  EXPECT_EQ(tune("standing.bag",
                 "--parameter wheel_odometry.alpha1 --parameter wheel_odometry.alpha4 "
                 "--parameter wheel_odometry.alpha3"),
            1);
  EXPECT_TRUE(contains(folder.read("stderr"),
                       "wheel_odometry.alpha1, wheel_odometry.alpha3 (the robot drives no more "
                       "than 0 m), wheel_odometry.alpha4 (the robot turns no more than 0 rad)"))
      << folder.read("stderr");
}

TEST_F(Tune, AgainInPlaceReadsWhatItWroteAndLeavesOneRemark) {
  makeStanding("standing.bag");
  folder.write("robot.yaml",
               "version: 1\nrobot: test\nlandmark_sensor: {sigma_range: 0.3}  # [m]\n");
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(tune("standing.bag", "--parameter landmark_sensor.sigma_bearing --out " + robot), 0)
        << folder.read("stderr");
  const auto file = folder.read("robot.yaml"), opening = std::string("# Noise tuned by");
  EXPECT_EQ(file.find(opening), file.rfind(opening)) << file;
  EXPECT_TRUE(contains(file, "landmark_sensor: {sigma_bearing: 0.02")) << file;
}

TEST_F(Tune, FindsBeforeItSearchesWhatWouldSpoilTheResult) {
  makeStanding("standing.bag");
  EXPECT_EQ(tune("standing.bag", "--out " + (folder / "nowhere/tuned.yaml")), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "No such file or directory"));
  EXPECT_FALSE(contains(folder.read("stdout"), "log-likelihood")) << folder.read("stdout");
  EXPECT_EQ(tune("standing.bag",
                 "--parameter landmark_sensor.sigma_range --parameter landmark_sensor.sigma_range"),
            1);
  EXPECT_TRUE(contains(folder.read("stderr"), "is to be tuned twice")) << folder.read("stderr");
  folder.write("robot.yaml", "{version: 1, robot: test}\n");
  EXPECT_EQ(tune("standing.bag"), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "cannot be put into the robot file"));
  EXPECT_FALSE(contains(folder.read("stdout"), "log-likelihood")) << folder.read("stdout");
}

TEST_F(Tune, ExitCodesTellFailureFromWrongUse) {
  BagMaker(folder / "x.bag").addOdometry().addObservations();
  EXPECT_EQ(tune("missing.bag"), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "there is no such file"));
  EXPECT_EQ(tune("x.bag", "--parameter wheel_odometry.drive"), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "'wheel_odometry.drive' is no number"));
  EXPECT_EQ(tune("x.bag", "--no-such-option"), 2);
  EXPECT_EQ(WEXITSTATUS(std::system((std::string(SLAM_TUNE) + " --help > /dev/null").c_str())), 0);
  EXPECT_EQ(WEXITSTATUS(std::system((std::string(SLAM_TUNE) + " 2> /dev/null").c_str())), 2);
}

}  // namespace
}  // namespace slam_ros
