// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser/scan_gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

class ScanGateTest : public testing::Test {
 protected:
  ScanGateTest() { gate.configure(LaserConfig()); }

  static LaserSweep sweepAt(double s, std::size_t beams = 3) {
    LaserSweep sweep;
    sweep.stamp = Stamp(durationFromSeconds(s));
    sweep.frame = "laser";
    sweep.angle_increment = 0.1f;
    sweep.angle_max = 0.1f * static_cast<float>(beams - 1);
    sweep.range_max = 8.0f;
    sweep.ranges.assign(beams, 2.0f);
    return sweep;
  }
  static LaserMount mount(const std::string& frame = "laser", double x = 1.0) {
    return {frame, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0))};
  }
  /// The stamps [s] that come out.
  std::vector<double> drain() {
    std::vector<double> stamps;
    for (next(); gate.scan(); next()) stamps.push_back(seconds(gate.scan()->stamp - Stamp()));
    return stamps;
  }
  Status next() { return gate.execute(); }
  /// What is said of a sweep that comes out empty.
  std::string refusalOf(const LaserSweep& sweep, const std::string& reason) {
    const auto before = gate.counters()[reason];
    gate.set(sweep);
    const auto status = next();
    EXPECT_TRUE(gate.scan() && gate.scan()->beams.empty()) << "it moves time on";
    EXPECT_EQ(gate.counters()[reason], before + 1);
    return status.message;
  }

  ScanGate gate;
};

bool says(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

TEST_F(ScanGateTest, HoldsScansUntilTheMountIsKnown) {
  for (const double s : {1.0, 1.5, 2.5}) gate.set(sweepAt(s));
  const auto status = next();
  EXPECT_TRUE(says(status.message, "laser of frame 'laser' is mounted")) << status.message;
  EXPECT_FALSE(gate.scan()) << "an identity mount is never assumed";
  gate.set(mount("another"));
  next();
  EXPECT_FALSE(gate.scan()) << "a mount of another frame is another laser's";
  gate.set(mount());
  next();
  ASSERT_TRUE(gate.scan());
  EXPECT_EQ(gate.scan()->sensor_pose.x(), 1.0);
  EXPECT_EQ(gate.scan()->beams.size(), 3u);
  EXPECT_EQ(drain(), (std::vector<double>{1.5, 2.5}));
  EXPECT_TRUE(gate.counters().all().empty());
}

TEST_F(ScanGateTest, TheFirstScanBeforeTheMountIsNotWorthAWord) {
  gate.set(sweepAt(1));
  EXPECT_TRUE(next().isOk());
}

TEST_F(ScanGateTest, LetsTheOldestOutEmptyWhenItHoldsTooMany) {
  for (std::size_t i = 0; i < ScanGate::kCapacity + 2; ++i)
    gate.set(sweepAt(0.1 * static_cast<double>(i)));
  EXPECT_EQ(drain(), (std::vector<double>{0.0, 0.1}));
  EXPECT_EQ(gate.counters()["no_mount"], 2u);
  gate.set(mount());
  EXPECT_EQ(drain().size(), ScanGate::kCapacity) << "the rest was held";
}

TEST_F(ScanGateTest, TheRobotFilesMountCountsForEveryFrame) {
  LaserConfig config;
  config.sensor_pose = {0.5, 0, 0, 0, 0, 0};
  gate.configure(config);
  gate.set(mount());
  gate.set(sweepAt(1));
  next();
  ASSERT_TRUE(gate.scan());
  EXPECT_EQ(gate.scan()->sensor_pose.x(), 0.5);
}

TEST_F(ScanGateTest, TheRobotFilesRangeShortensTheLasers) {
  LaserConfig config;
  config.range_max = 1.5;
  gate.configure(config);
  gate.set(mount());
  gate.set(sweepAt(1));
  next();
  ASSERT_TRUE(gate.scan());
  EXPECT_FALSE(gate.scan()->beams[0].hit);
  EXPECT_EQ(gate.scan()->beams[0].range, 1.5f);
}

TEST_F(ScanGateTest, ScansCarryTheNoiseThatTheRobotFileNames) {
  LaserConfig config;
  config.relative_sigma = 0.02;
  gate.configure(config);
  gate.set(mount());
  gate.set(sweepAt(1));
  next();
  ASSERT_TRUE(gate.scan());
  EXPECT_EQ(gate.scan()->relative_sigma, 0.02);
  config.relative_sigma = -0.1;
  EXPECT_THROW(gate.configure(config), ConfigError);
}

TEST_F(ScanGateTest, TheRobotFilesRangeStandsInForOneThatIsInfinite) {
  auto sweep = sweepAt(1);
  sweep.range_max = std::numeric_limits<float>::infinity();
  gate.set(mount());
  EXPECT_TRUE(says(refusalOf(sweep, "bad_scan"), "range_max is inf"));
  LaserConfig config;
  config.range_max = 5.0;
  gate.configure(config);
  gate.set(mount());
  gate.set(sweep);
  EXPECT_TRUE(next().isOk());
  EXPECT_EQ(gate.scan()->beams.size(), 3u);
}

TEST_F(ScanGateTest, ASweepThatCannotBeUsedComesOutEmptyAndSaysWhy) {
  gate.set(mount());
  auto sweep = sweepAt(1);
  sweep.angle_increment = 0.0f;
  const auto sentence = refusalOf(sweep, "bad_scan");
  EXPECT_TRUE(says(sentence, "angle_increment is 0")) << sentence;
}

TEST_F(ScanGateTest, AnotherNumberOfBeamsIsFine) {
  gate.set(mount());
  for (const std::size_t beams : {3, 7, 2}) {
    gate.set(sweepAt(static_cast<double>(beams), beams));
    EXPECT_TRUE(next().isOk());
    ASSERT_TRUE(gate.scan());
    EXPECT_EQ(gate.scan()->beams.size(), beams);
  }
}

TEST_F(ScanGateTest, ASidewaysMountIsToldWithEveryScan) {
  auto sideways = mount();
  sideways.T_base_laser.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()));
  gate.set(sideways);
  const auto sentence = refusalOf(sweepAt(1), "bad_mount");
  EXPECT_TRUE(says(sentence, "not horizontal")) << sentence;
  EXPECT_TRUE(says(sentence, "laser.sensor_pose")) << sentence;
  gate.set(mount());
  gate.set(sweepAt(2));
  EXPECT_TRUE(next().isOk()) << "once it is corrected all is well";
}

TEST_F(ScanGateTest, ALaserThatTellsNoRangeForASecondIsWorthAWord) {
  gate.set(mount());
  auto blind = sweepAt(1);
  blind.ranges.assign(3, std::numeric_limits<float>::quiet_NaN());
  std::string said;
  for (int i = 0; i <= 10; ++i) {
    blind.stamp += std::chrono::milliseconds(100);
    EXPECT_EQ(said, "") << "said after " << i << " of them";
    said = refusalOf(blind, "no_range");
  }
  EXPECT_TRUE(says(said, "laser of frame 'laser' has told no range since 1.1")) << said;
  gate.set(sweepAt(3));
  EXPECT_TRUE(next().isOk());
  blind.stamp = Stamp(durationFromSeconds(3.1));
  EXPECT_EQ(refusalOf(blind, "no_range"), "") << "it has seen meanwhile";
}

TEST_F(ScanGateTest, AScanOfAnotherFrameHoldsUpNoneBehindIt) {
  gate.set(mount());
  for (const auto* frame : {"", "another"}) {
    const auto before = gate.counters()["no_mount"];
    auto foreign = sweepAt(1.0);
    foreign.frame = frame;
    gate.set(foreign);
    EXPECT_TRUE(drain().empty()) << "its mount may still come";
    EXPECT_EQ(gate.held()["no_mount"], 1u);
    gate.set(sweepAt(1.1));
    const auto status = next();
    ASSERT_TRUE(gate.scan());
    EXPECT_TRUE(gate.scan()->beams.empty());
    EXPECT_TRUE(says(status.message, "laser of frame '" + foreign.frame + "' is mounted"));
    EXPECT_EQ(gate.counters()["no_mount"], before + 1);
    next();
    ASSERT_TRUE(gate.scan());
    EXPECT_EQ(gate.scan()->beams.size(), 3u);
    EXPECT_EQ(gate.held()["no_mount"], 0u);
  }
}

TEST_F(ScanGateTest, AMountOfTheRobotFileNeedsSixValues) {
  LaserConfig config;
  config.sensor_pose = {1, 2, 3};
  EXPECT_TRUE(test::oneSays(test::faultsOf([&] { gate.configure(config); }),
                            {"laser.sensor_pose", "3 values"}));
}

TEST_F(ScanGateTest, ResetForgetsScansAndKeepsTheMount) {
  gate.set(sweepAt(1));
  gate.set(mount());
  gate.reset();
  EXPECT_TRUE(drain().empty());
  gate.set(sweepAt(2));
  EXPECT_EQ(drain(), (std::vector<double>{2}));
}

}  // namespace
}  // namespace slam
