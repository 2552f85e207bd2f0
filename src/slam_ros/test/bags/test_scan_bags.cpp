// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "bag_maker.hpp"
#include "found_inputs.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::findInputs;
using test::messageOf;
using test::Topics;

sensor_msgs::LaserScan scanAt(double t) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = test::at(t);
  scan.ranges = {1, 2, 3};
  return scan;
}

/// Makes motion of scans.
class ScanSource final : public slam::OdometrySource {
 public:
  void describe(slam::Ports& ports) override {
    ports.takes<slam::LaserScan>("scan", "laser scans", [](const slam::LaserScan&) {});
    ports.makes<slam::Motion>("motion", motion_);
  }
  void configure(slam::Settings&) override {}
  slam::Status execute() override { return slam::Status::ok(); }
  const std::optional<slam::Motion>& motion() const override { return motion_; }
  slam::Counters counters() const override { return {}; }
  void reset() override {}

 private:
  std::optional<slam::Motion> motion_;
};
const slam::Registrar<slam::OdometrySource, ScanSource> kScanSource("test_scans");

struct ScanBags : ::testing::Test {
  /// A bag with odometry and what `fill` adds.
  template <class Fill>
  std::string bag(Fill fill) {
    BagMaker maker(folder / "x.bag");
    maker.addOdometry();
    fill(maker);
    return folder / "x.bag";
  }
  static slam::ProductConfig gridProduct() {
    slam::ProductConfig product;
    product.backend = "pf";
    product.map = slam::MapKind::kGrid;
    return product;
  }
  test::Folder folder;
};

TEST_F(ScanBags, AGridNeedsScansAndCanDoWithoutLandmarks) {
  const BagReader reader(bag([](auto& maker) { maker.add("/base_scan", 1, scanAt(1)); }));
  const auto inputs = findInputs(reader, gridProduct());
  EXPECT_EQ(inputs.topicsOf("scan"), Topics{"/base_scan"});
  EXPECT_EQ(inputs.topicsOf("observations"), Topics{});
  ASSERT_EQ(inputs.notes().size(), 1u);
  EXPECT_TRUE(contains(inputs.notes()[0], "/base_scan is the input scan")) << inputs.notes()[0];
  std::size_t ranges = 0;
  const auto sinks =
      test::sinksFor<slam::LaserSweep>([&](const auto& sweep) { ranges += sweep.ranges.size(); });
  reader.read(inputs.readers([&](const auto&) { return sinks; }));
  EXPECT_EQ(ranges, 3u);
}

TEST_F(ScanBags, AGridTakesLandmarksWhereThereAreSome) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/scan", 1, scanAt(1)).addObservations(); }));
  const auto inputs = findInputs(reader, gridProduct());
  EXPECT_EQ(inputs.topicsOf("scan"), Topics{"/scan"});
  EXPECT_EQ(inputs.topicsOf("observations"), Topics{"/observations"});
}

TEST_F(ScanBags, SaysThatTheScansAreMissing) {
  const BagReader reader(bag([](auto& maker) { maker.addObservations(); }));
  const auto message = messageOf([&] { findInputs(reader, gridProduct()); });
  EXPECT_TRUE(contains(message, "lacks laser scans: 'scan' (sensor_msgs/LaserScan)")) << message;
}

TEST_F(ScanBags, OneOfSeveralLasersMustBeChosen) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/front", 1, scanAt(1)).add("/back", 1, scanAt(1)); }));
  const auto message = messageOf([&] { findInputs(reader, gridProduct()); });
  EXPECT_TRUE(contains(message, "--remap scan:=/back")) << message;
  EXPECT_EQ(findInputs(reader, gridProduct(), {{"scan", "/front"}}).topicsOf("scan"),
            Topics{"/front"});
}

TEST_F(ScanBags, TheOnlyScansThereAreAreFoundAlthoughTheRobotCallsThemOtherwise) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/scan", 1, scanAt(1)).addObservations(); }));
  BagContext context;
  context.topics.scan = "/laser";
  const BagInputs inputs(reader, slam::createComponents(gridProduct()), context, {});
  EXPECT_EQ(inputs.topicsOf("scan"), Topics{"/scan"});
  ASSERT_EQ(inputs.notes().size(), 1u);
  EXPECT_TRUE(contains(inputs.notes()[0], "/scan is the input scan")) << inputs.notes()[0];
}

/// Runs a grid product on ten scans of these frames, of which only `laser` has a mount; odometry
/// comes with them. @return the exit status
int runOnScans(const test::Folder& folder, const std::string& bag) {
  const auto product = folder.write("product.yaml",
                                    "{version: 1, product: test, backend: pf, map: grid, "
                                    "pf: {particles: 3}}");
  const auto command = std::string(SLAM_OFFLINE) + " " + product + " --robot " +
                       folder.write("robot.yaml", "{version: 1, robot: test}") + " --bag " + bag +
                       " --out " + (folder / "run") + " > " + (folder / "stdout") + " 2>&1";
  return std::system(command.c_str());
}

void addScan(BagMaker& maker, double time, const std::string& frame) {
  auto scan = scanAt(time);
  scan.header.frame_id = frame;
  scan.angle_min = -0.1f;
  scan.angle_max = scan.angle_increment = 0.1f;
  scan.range_max = 8.0f;
  maker.add("/scan", time, scan);
}

TEST_F(ScanBags, CountsTheScansThatWaitForTheirMountAtTheEnd) {
  const auto path = bag([](auto& maker) {
    maker.add("/tf_static", 0, test::transform("base_link", "laser", 0));
    for (int i = 0; i < 10; ++i) addScan(maker, 0.1 * i, i < 7 && i != 3 ? "laser" : "nowhere");
  });
  ASSERT_EQ(runOnScans(folder, path), 0);
  EXPECT_TRUE(contains(folder.read("stdout"), "run: 7 poses")) << folder.read("stdout");
  EXPECT_TRUE(contains(folder.read("stdout"), "laser_no_mount 4")) << folder.read("stdout");
}

TEST_F(ScanBags, FailsWhereNoScanHasAMountAlthoughThereIsOdometry) {
  const auto path = bag([](auto& maker) {
    for (int i = 0; i < 10; ++i) addScan(maker, 0.1 * i, "nowhere");
  });
  EXPECT_NE(runOnScans(folder, path), 0);
  EXPECT_TRUE(contains(folder.read("stdout"), "does not tell the transform base_link -> nowhere"))
      << folder.read("stdout");
}

TEST_F(ScanBags, FailsWhereTheMountOfAllScansCannotBeUsed) {
  auto mount = test::transform("base_link", "laser", 0);
  mount.transforms[0].transform.rotation.w = NAN;
  const auto path = bag([&](auto& maker) {
    maker.add("/tf_static", 0, mount);
    for (int i = 0; i < 10; ++i) addScan(maker, 0.1 * i, "laser");
  });
  EXPECT_NE(runOnScans(folder, path), 0);
  EXPECT_TRUE(
      contains(folder.read("stdout"),
               "the transform base_link -> laser of the bag's /tf_static cannot be used: its "
               "rotation is no rotation"))
      << folder.read("stdout");
}

/// Of which the odometry source makes motion of scans.
slam::ProductConfig scanOdometryProduct() {
  slam::ProductConfig product;
  product.odometry = "test_scans";
  return product;
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
  const auto inputs = findInputs(BagReader(both), scanOdometryProduct());
  EXPECT_EQ(inputs.topicsOf("motion"), Topics{"/motion"});
  EXPECT_EQ(inputs.topicsOf("scan"), Topics{}) << "motion would be made twice";
  const auto without_scans = bag(with_motion);
  EXPECT_EQ(findInputs(BagReader(without_scans), scanOdometryProduct()).topicsOf("motion"),
            Topics{"/motion"});
}

TEST_F(ScanBags, AnOdometrySourceMakesMotionOfScansThatOthersTakeAsWell) {
  const auto path = bag([](auto& maker) {
    maker.add("/motion", 1, motionAt(1)).add("/scan", 1, scanAt(1)).addObservations();
  });
  auto product = scanOdometryProduct();
  product.modules["pointmap"] = true;
  const auto inputs = findInputs(BagReader(path), product);
  EXPECT_EQ(inputs.topicsOf("scan"), Topics{"/scan"});
  EXPECT_EQ(inputs.topicsOf("motion"), Topics{}) << "motion would come twice";
  ASSERT_EQ(inputs.notes().size(), 1u);
  EXPECT_EQ(inputs.notes()[0],
            "the motion that the bag carries is left out: the odometry source makes it of the "
            "input 'scan', which others take as well");
}

TEST_F(ScanBags, AnOdometrySourceThatTakesScansNeedsThem) {
  const auto path = bag([](auto& maker) { maker.addObservations(); });
  const auto message = messageOf([&] { findInputs(BagReader(path), scanOdometryProduct()); });
  EXPECT_TRUE(contains(message, "lacks laser scans: 'scan'")) << message;
}

TEST_F(ScanBags, TheFlowTellsWhoTakesAnInput) {
  auto product = gridProduct();
  product.detector = "apriltag";
  product.modules["pointmap"] = true;
  const slam::DataFlow flow(slam::createComponents(product));
  ASSERT_EQ(flow.parts().size(), 4u);
  const auto& odometry = flow.parts()[0];
  const auto namesOf = [](const auto& inputs) {
    std::vector<std::string> names;
    for (const auto& input : inputs) names.push_back(input.name);
    return names;
  };
  EXPECT_EQ(namesOf(odometry.inputs), std::vector<std::string>{"odom"});
  EXPECT_EQ(namesOf(flow.parts()[1].inputs), std::vector<std::string>{"camera"});
  for (const auto part : {2, 3})
    EXPECT_NE(flow.parts()[part].input("scan", slam::kindOf<slam::LaserSweep>()), nullptr) << part;
  EXPECT_EQ(namesOf(flow.inputsOfAlone(odometry)), std::vector<std::string>{"odom"});
  EXPECT_TRUE(flow.inputsOfAlone(flow.parts()[2]).empty()) << "the point map takes scans as well";
  EXPECT_FALSE(flow.leadsToSteps("odom", slam::kindOf<slam::OdometrySample>()));
  EXPECT_TRUE(flow.leadsToSteps("camera", slam::kindOf<slam::Image>()));
  EXPECT_TRUE(flow.leadsToSteps("scan", slam::kindOf<slam::LaserSweep>()));
}

TEST_F(ScanBags, AProductOfLandmarksDoesNotTouchTheScans) {
  const BagReader reader(
      bag([](auto& maker) { maker.add("/scan", 1, scanAt(1)).addObservations(); }));
  EXPECT_EQ(findInputs(reader).topicsOf("scan"), Topics{});
}

}  // namespace
}  // namespace slam_ros
