// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "bag_maker.hpp"
#include "slam_ros/bag_inputs.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::messageOf;

sensor_msgs::LaserScan scanAt(double t) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = test::at(t);
  scan.ranges = {1, 2, 3};
  return scan;
}

struct ScanBags : ::testing::Test {
  /// A bag with odometry and what `fill` adds.
  template <class Fill>
  std::string bag(Fill fill) {
    BagMaker maker(folder / "x.bag");
    maker.addOdometry();
    fill(maker);
    return folder / "x.bag";
  }
  static InputNeeds gridNeeds() {
    InputNeeds needs;
    needs.scans = true;
    needs.landmarks = false;
    return needs;
  }
  test::Folder folder;
};

TEST_F(ScanBags, AGridNeedsScansAndCanDoWithoutLandmarks) {
  const BagReader reader(bag([](auto& maker) { maker.add("/base_scan", 1, scanAt(1)); }));
  const auto inputs = findInputs(reader, gridNeeds(), {});
  EXPECT_EQ(inputs.scan, "/base_scan");
  EXPECT_EQ(inputs.observations, "");
  ASSERT_EQ(inputs.notes.size(), 1u);
  EXPECT_TRUE(contains(inputs.notes[0], "/base_scan is the input scan")) << inputs.notes[0];
  std::size_t ranges = 0;
  InputSinks sinks;
  sinks.odom = [](const auto&) {};
  sinks.scan = [&](const auto& scan) { ranges += scan.ranges.size(); };
  reader.read(handlersFor(inputs, sinks));
  EXPECT_EQ(ranges, 3u);
}

TEST_F(ScanBags, AGridTakesLandmarksWhereThereAreSome) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/scan", 1, scanAt(1)).addObservations(); }));
  const auto inputs = findInputs(reader, gridNeeds(), {});
  EXPECT_EQ(inputs.scan, "/scan");
  EXPECT_EQ(inputs.observations, "/observations");
}

TEST_F(ScanBags, SaysThatTheScansAreMissing) {
  const BagReader reader(bag([](auto& maker) { maker.addObservations(); }));
  const auto message = messageOf([&] { findInputs(reader, gridNeeds(), {}); });
  EXPECT_TRUE(contains(message, "lacks laser scans: 'scan' (sensor_msgs/LaserScan)")) << message;
}

TEST_F(ScanBags, OneOfSeveralLasersMustBeChosen) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/front", 1, scanAt(1)).add("/back", 1, scanAt(1)); }));
  const auto message = messageOf([&] { findInputs(reader, gridNeeds(), {}); });
  EXPECT_TRUE(contains(message, "--remap scan:=/back")) << message;
  EXPECT_EQ(findInputs(reader, gridNeeds(), {{"scan", "/front"}}).scan, "/front");
}

TEST_F(ScanBags, CountsTheScansThatWaitForTheirMountAtTheEnd) {
  const auto path = bag([](auto& maker) {
    maker.add("/tf_static", 0, test::transform("base_link", "laser", 0));
    for (int i = 0; i < 10; ++i) {
      auto scan = scanAt(0.1 * i);
      scan.header.frame_id = i < 7 && i != 3 ? "laser" : "nowhere";
      scan.angle_min = -0.1f;
      scan.angle_max = scan.angle_increment = 0.1f;
      scan.range_max = 8.0f;
      maker.add("/scan", 0.1 * i, scan);
    }
  });
  const auto product = folder.write("product.yaml",
                                    "{version: 1, product: test, backend: pf, map: grid, "
                                    "pf: {particles: 3}}");
  const auto command = std::string(SLAM_OFFLINE) + " " + product + " --robot " +
                       folder.write("robot.yaml", "{version: 1, robot: test}") + " --bag " + path +
                       " --out " + (folder / "run") + " > " + (folder / "stdout");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(contains(folder.read("stdout"), "run: 7 poses")) << folder.read("stdout");
  EXPECT_TRUE(contains(folder.read("stdout"), "laser_no_mount 4")) << folder.read("stdout");
}

/// Of a product whose odometry source makes motion of scans.
InputNeeds scanOdometryNeeds() {
  InputNeeds needs;
  needs.wheels = false;
  needs.scans = true;
  needs.of_odometry = {"scan"};
  needs.of_backend = {"motion", "observations"};
  return needs;
}

slam_msgs::Motion motionAt(double t) {
  slam_msgs::Motion motion;
  motion.start = test::at(t - 1);
  motion.end = test::at(t);
  return motion;
}

TEST_F(ScanBags, MotionInTheBagTakesTheScansPlaceOfAnOdometrySource) {
  const auto with_motion = [](auto& maker) {
    maker.add("/motion", 1, motionAt(1)).addObservations();
  };
  const auto both = bag([&](auto& maker) {
    with_motion(maker);
    maker.add("/scan", 1, scanAt(1));
  });
  const auto inputs = findInputs(BagReader(both), scanOdometryNeeds(), {});
  EXPECT_EQ(inputs.motion, "/motion");
  EXPECT_EQ(inputs.scan, "") << "motion would be made twice";
  const auto without_scans = bag(with_motion);
  EXPECT_EQ(findInputs(BagReader(without_scans), scanOdometryNeeds(), {}).motion, "/motion");
}

TEST_F(ScanBags, AnOdometrySourceMakesMotionOfScansThatOthersTakeAsWell) {
  const auto path = bag([](auto& maker) {
    maker.add("/motion", 1, motionAt(1)).add("/scan", 1, scanAt(1)).addObservations();
  });
  auto needs = scanOdometryNeeds();
  needs.of_modules = {"scan", "motion", "pose"};
  const auto inputs = findInputs(BagReader(path), needs, {});
  EXPECT_EQ(inputs.scan, "/scan");
  EXPECT_EQ(inputs.motion, "") << "motion would come twice";
  ASSERT_EQ(inputs.notes.size(), 1u);
  EXPECT_TRUE(contains(inputs.notes[0], "the motion that the bag carries is left out"));
}

TEST_F(ScanBags, AnOdometrySourceThatTakesScansNeedsThem) {
  const auto path = bag([](auto& maker) { maker.addObservations(); });
  const auto message = messageOf([&] { findInputs(BagReader(path), scanOdometryNeeds(), {}); });
  EXPECT_TRUE(contains(message, "lacks laser scans: 'scan'")) << message;
}

TEST_F(ScanBags, NeedsTellWhoTakesAnInput) {
  slam::ProductConfig product;
  product.backend = "pf";
  product.map = "grid";
  product.detector = "apriltag";
  product.modules["pointmap"] = true;
  const auto needs = needsOf(product);
  EXPECT_EQ(needs.of_odometry, std::set<std::string>{"odom"});
  EXPECT_EQ(needs.of_detector, std::set<std::string>{"camera"});
  EXPECT_EQ(needs.of_backend.count("scan"), 1u);
  EXPECT_EQ(needs.of_modules.count("scan"), 1u);
  EXPECT_TRUE(needs.isOfOdometryAlone("odom"));
  EXPECT_FALSE(needs.isOfOdometryAlone("scan"));
  product.map = "landmarks";
  EXPECT_EQ(needsOf(product).of_backend.count("scan"), 0u);
}

TEST_F(ScanBags, AProductOfLandmarksDoesNotTouchTheScans) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/scan", 1, scanAt(1)).addObservations(); }));
  EXPECT_EQ(findInputs(reader, InputNeeds(), {}).scan, "");
}

}  // namespace
}  // namespace slam_ros
