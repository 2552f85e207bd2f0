// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "camera_bag.hpp"
#include "found_inputs.hpp"
#include "slam_ros/bag_flow.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;

slam::Stamp stampOf(int i) { return fromRos(test::at(0.1 * i)); }

struct Flow : ::testing::Test {
  Flow() {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry().addObservations();
    test::addCamera(bag, "/ceiling_camera/image_raw", "/ceiling_camera/camera_info");
    sensor_msgs::LaserScan scan;
    scan.header.stamp = test::at(1);
    bag.add("/scan", 1, scan);
  }
  /// The flow of a product's inputs.
  BagFlow& start(const slam::ProductConfig& product, bool has_point_map = false) {
    inputs.emplace(test::findInputs(BagReader(folder / "x.bag"), product));
    const auto warn = [this](const std::string& warning) { warnings.push_back(warning); };
    return flow.emplace(*inputs,
                        BagFlow::Options{has_point_map, std::chrono::seconds(1), warn, patience});
  }
  BagInput::Gate gateOf(const std::string& port) {
    const auto& found = inputs->found();
    return flow->gateOf(*std::find_if(found.begin(), found.end(),
                                      [&](const auto& input) { return input.port == port; }));
  }
  /// Sends one message more once `acknowledge` was called.
  template <class Acknowledge>
  void expectRoomAfter(const BagInput::Gate& gate, int sent, Acknowledge acknowledge) {
    std::thread answering(acknowledge);
    EXPECT_TRUE(gate(stampOf(sent)));
    answering.join();
    EXPECT_EQ(warnings, std::vector<std::string>{});
  }

  test::Folder folder;
  std::optional<BagInputs> inputs;
  std::vector<std::string> warnings;
  FlowWindow::Timeout patience = BagFlow::Options().patience;
  std::optional<BagFlow> flow;
};

TEST_F(Flow, OfSeveralInputsOfAComponentTheLargestMessagesAreWaitedFor) {
  slam::ProductConfig product;
  product.odometry = "visual_wheel";
  start(product);
  const auto wheels = gateOf("odom"), images = gateOf("ceiling_camera");
  for (int i = 0; i < 10 * static_cast<int>(kInFlight); ++i) ASSERT_TRUE(wheels(stampOf(i)));
  const int few = static_cast<int>(kImagesInFlight);
  for (int i = 0; i < few; ++i) ASSERT_TRUE(images(stampOf(i)));
  expectRoomAfter(images, few, [this] {
    slam_msgs::Progress progress;
    progress.motion = toRos(stampOf(0));  // which is made of images
    flow->acknowledge(progress);
  });
}

TEST_F(Flow, WhatTheLastOfAChainMakesOfAnImageAcknowledgesIt) {
  slam::ProductConfig product;
  product.backend = "rat";
  product.detector = "none";
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    test::addCamera(bag, "/camera/image_raw", "/camera/camera_info");
  }
  start(product);
  const auto images = gateOf("camera"), wheels = gateOf("odom");
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(images(stampOf(i)));
    ASSERT_TRUE(wheels(stampOf(i)));
  }
  expectRoomAfter(wheels, 6,
                  [this] {  // motion is no further ahead of the images than half a second
                    slam_msgs::Progress progress;
                    progress.motion = toRos(stampOf(3));
                    flow->acknowledge(progress);
                    progress.inputs = {"local_view", "pose_cells"};  // a view alone is not through
                    progress.newest = {toRos(stampOf(3)), toRos(stampOf(1))};
                    flow->acknowledge(progress);
                  });
  slam_msgs::Progress progress;
  progress.motion = toRos(stampOf(6));
  progress.inputs = {"pose_cells"};
  progress.newest = {toRos(stampOf(3))};
  flow->acknowledge(progress);
  ASSERT_TRUE(images(stampOf(7)));
  EXPECT_EQ(flow->finish(), 0u) << "an image beyond all motion is not waited for";
  EXPECT_EQ(inputs->flow().lastOutputs(inputs->flow().parts()[1]).front().name, "pose_cells");
}

TEST_F(Flow, WhatAModuleOfItsOwnNodeletTakesItAcknowledges) {
  slam::ProductConfig product;
  product.modules["pointmap"] = true;
  start(product, true);
  const auto scans = gateOf("scan");
  const int few = static_cast<int>(kScansInFlight);
  for (int i = 0; i < few; ++i) ASSERT_TRUE(scans(stampOf(i)));
  expectRoomAfter(scans, few, [this] {
    slam_msgs::Progress progress;
    progress.scans = toRos(stampOf(0));
    flow->acknowledgeOfPointMap(progress);
  });
}

TEST_F(Flow, SaysOnceThatASourceIsNotWaitedForAnyMore) {
  slam::ProductConfig product;
  product.backend = "pf";
  product.map = slam::MapKind::kGrid;  // which takes steps for scans and for observations
  patience = FlowWindow::Timeout(20);
  start(product);
  const auto scans = gateOf("scan");
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(scans(stampOf(i)));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(
      warnings[0],
      "messages sent 0.5 s of the bag's time ago were not acknowledged for 0.02 s; from now on "
      "the inputs are no longer kept within that time of one another");
}

TEST_F(Flow, NothingMayBeSentOnceItWasStopped) {
  start({}).stop();
  EXPECT_FALSE(gateOf("odom")(stampOf(0)));
  EXPECT_EQ(flow->finish(), 0u);
}

}  // namespace
}  // namespace slam_ros
