// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <slam_msgs/PoseCellState.h>

#include "camera_bag.hpp"
#include "found_inputs.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::messageOf;
using test::Topics;

/// Bags that carry what a component of the product would make.
struct CarriedData : ::testing::Test {
  CarriedData() { product.detector = "aruco"; }
  /// A bag with these topics; by the topic's name each is odometry, motion, observations, images or
  /// pose cells.
  void write(const Topics& topics) {
    BagMaker bag(folder / "x.bag");
    for (const auto& topic : topics) {
      if (test::contains(topic, "odom")) bag.addOdometry(topic);
      if (test::contains(topic, "motion")) bag.add(topic, 0, test::motion(0, 1, 0));
      if (test::contains(topic, "observations")) bag.addObservations(topic);
      if (test::contains(topic, "image")) test::addCamera(bag, topic, "", 0.2);
      if (test::contains(topic, "pose_cells")) bag.add(topic, 1, slam_msgs::PoseCellState());
    }
  }
  BagInputs find(const std::vector<Remap>& remaps = {}) const {
    return test::findInputs(BagReader(folder / "x.bag"), product, remaps);
  }
  std::string faultOf(const std::vector<Remap>& remaps) const {
    return messageOf([&] { find(remaps); });
  }
  test::Folder folder;
  slam::ProductConfig product;
};

TEST_F(CarriedData, OfAnotherNameLeavesTheProductsOwnSensorsIn) {
  write({"/odom", "/robot2/motion", "/camera/image_raw", "/robot2/observations"});
  const auto inputs = find();
  EXPECT_EQ(inputs.topicsOf("odom"), Topics{"/odom"});
  EXPECT_EQ(inputs.topicsOf("camera"), Topics{"/camera/image_raw"});
  EXPECT_EQ(inputs.topicsOf("motion"), Topics{});
  EXPECT_EQ(inputs.topicsOf("observations"), Topics{});
  EXPECT_EQ(inputs.notes(), std::vector<std::string>{}) << "that of a search that came to nothing";
}

TEST_F(CarriedData, OfSeveralOtherRobotsNeedsNoChoiceWhereTheSensorsAreThere) {
  write({"/odom", "/robot2/motion", "/robot3/motion", "/observations"});
  EXPECT_EQ(find().topicsOf("odom"), Topics{"/odom"});
}

TEST_F(CarriedData, OfAnotherNameCountsWhereTheSensorsAreNot) {
  write({"/recorded/motion", "/recorded/observations"});
  const auto inputs = find();
  EXPECT_EQ(inputs.topicsOf("motion"), Topics{"/recorded/motion"});
  EXPECT_EQ(inputs.topicsOf("observations"), Topics{"/recorded/observations"});
  EXPECT_TRUE(inputs.isLeftOut("odometry"));
  EXPECT_EQ(inputs.notes().size(), 4u) << "each name, and each component that is left out";
}

TEST_F(CarriedData, OfAnotherNameCountsWhereARemappingSaysSo) {
  write({"/odom", "/robot2/motion", "/observations"});
  const auto inputs = find({{"motion", "/robot2/motion"}});
  EXPECT_EQ(inputs.topicsOf("motion"), Topics{"/robot2/motion"});
  EXPECT_EQ(inputs.topicsOf("odom"), Topics{});
}

TEST_F(CarriedData, OfTheOwnNameCountsAlthoughSeveralSensorsCouldBeMeant) {
  write({"/odom", "/observations", "/left/image", "/right/image"});
  EXPECT_EQ(find().topicsOf("observations"), Topics{"/observations"});
}

TEST_F(CarriedData, GiveWayToASensorThatARemappingNames) {
  write({"/odom", "/motion", "/observations", "/ceiling/image"});
  EXPECT_EQ(find().topicsOf("odom"), Topics{});
  const auto wheels = find({{"odom", "/odom"}});
  EXPECT_EQ(wheels.topicsOf("odom"), Topics{"/odom"});
  EXPECT_EQ(wheels.topicsOf("motion"), Topics{});
  EXPECT_FALSE(wheels.isLeftOut("odometry"));
  product.odometry = "visual";
  const auto ceiling = find({{"ceiling_camera", "/ceiling/image"}});
  EXPECT_EQ(ceiling.topicsOf("ceiling_camera"), Topics{"/ceiling/image"});
  EXPECT_EQ(ceiling.topicsOf("motion"), Topics{});
}

TEST_F(CarriedData, AreToldWithHowToAskForTheSensorsInstead) {
  write({"/odom", "/motion", "/observations"});
  product.detector = "none";
  ASSERT_EQ(find().notes().size(), 1u);
  EXPECT_EQ(
      find().notes()[0],
      "the bag carries motion: the odometry component is left out; --remap odom:=TOPIC has it "
      "take that topic's messages instead");
}

TEST_F(CarriedData, AndTheirSensorsCannotBothBeRemapped) {
  write({"/odom", "/motion", "/observations"});
  EXPECT_EQ(faultOf({{"odom", "/odom"}, {"motion", "/motion"}}),
            "the remapping motion:=/motion would have no effect: the odometry component makes what "
            "the input 'motion' takes in; leave it out");
}

TEST_F(CarriedData, OfAStageLeaveOutTheOnesBeforeIt) {
  product.backend = "rat";
  product.detector = "none";
  write({"/odom", "/camera/image_raw"});
  EXPECT_EQ(find().topicsOf("camera"), Topics{"/camera/image_raw"});
  write({"/odom", "/camera/image_raw", "/pose_cells"});
  const auto inputs = find();
  EXPECT_EQ(inputs.topicsOf("pose_cells"), Topics{"/pose_cells"});
  EXPECT_EQ(inputs.topicsOf("camera"), Topics{}) << "nobody takes images any more";
  EXPECT_TRUE(inputs.isLeftOut("pose_cells"));
  EXPECT_TRUE(inputs.isLeftOut("local_view"));
  EXPECT_FALSE(inputs.isLeftOut("odometry"));
  write({"/odom"});
  EXPECT_TRUE(test::contains(faultOf({}), "lacks images: 'camera/image_raw'")) << faultOf({});
}

TEST_F(CarriedData, RemappingsOfInputsThatNobodyTakesAreRefused) {
  write({"/odom", "/observations", "/left/image", "/right/image/compressed"});
  EXPECT_EQ(faultOf({{"ceiling_camera", "/left/image"}}),
            "the remapping ceiling_camera:=/left/image would have no effect: no component of the "
            "product takes the input 'ceiling_camera'; leave it out");
  EXPECT_EQ(faultOf({{"camera", "/left/image"}, {"camera", "/right/image"}}),
            "the remapping camera/compressed:=/right/image/compressed would have no effect: the "
            "input 'camera' comes from /left/image; leave it out");
}

}  // namespace
}  // namespace slam_ros
