// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/product_components.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/point_map/point_map.hpp"

namespace slam {
namespace {

using test::faultsOf;
using test::oneSays;

ProductConfig wholeProduct() {
  ProductConfig product;
  product.backend = "pf";
  product.odometry = "visual";
  product.detector = "apriltag";
  product.map = MapKind::kGrid;
  product.modules["pointmap"] = true;
  return product;
}

bool ownsEdge(const std::string& odometry) {
  return ownsOdometryEdge(*Registry<OdometrySource>::instance().create(odometry));
}

TEST(ProductComponentsTest, AreListedInTheOrderOfTheFlowBeforeTheyAreConfigured) {
  const auto parts = createComponents(wholeProduct());
  std::vector<std::string> titles, keys;
  for (const auto& part : inOrder(parts)) {
    titles.push_back(part.title());
    keys.push_back(part.key);
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"odometry source 'visual'", "detector 'apriltag'",
                                              "back-end 'pf'", "additional module 'pointmap'"}));
  EXPECT_EQ(keys, (std::vector<std::string>{"odometry", "detector", "backend", "pointmap"}));
}

TEST(ProductComponentsTest, OfThatMapHaveItsPortsAndCapabilities) {
  auto product = wholeProduct();
  auto parts = createComponents(product);
  EXPECT_NE(portsOf(*parts.estimator).input("scan", kindOf<LaserScan>()), nullptr);
  EXPECT_NE(parts.estimator->capabilities().find<GridMapper>(), nullptr);
  product.map = MapKind::kLandmarks;
  parts = createComponents(product);
  EXPECT_EQ(portsOf(*parts.estimator).input("scan", kindOf<LaserScan>()), nullptr);
  EXPECT_EQ(parts.estimator->capabilities().find<GridMapper>(), nullptr);
}

TEST(ProductComponentsTest, ThatAreNotThereAreNotListed) {
  ProductConfig product;
  product.odometry = product.detector = "none";
  const auto parts = createComponents(product);
  ASSERT_EQ(inOrder(parts).size(), 1u);
  EXPECT_EQ(inOrder(parts)[0].component, parts.estimator.get());
}

TEST(ProductComponentsTest, OfALibraryThatIsMissingAreRefusedWithItsName) {
  ProductConfig product;
  product.libraries = {"libslam_nowhere.so"};
  product.backend = "nowhere";
  const auto faults = faultsOf([&] { createComponents(product); });
  EXPECT_EQ(faults.size(), 1u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"cannot load the product's library libslam_nowhere.so"}));
}

TEST(OdometryEdge, IsTheDriversWhereTheSourceTakesInNothingElse) {
  EXPECT_FALSE(ownsEdge("wheel"));
  EXPECT_FALSE(ownsEdge("wheel_imu")) << "it moves along the driver's frame";
  EXPECT_TRUE(ownsEdge("visual"));
  EXPECT_TRUE(ownsEdge("visual_wheel"));
  EXPECT_TRUE(ownsEdge("visual_imu"));
  EXPECT_TRUE(ownsEdge("laser_imu"));
  EXPECT_TRUE(ownsEdge("command"));
}

TEST(PointMapPorts, GiveTheMapOnlyAfterAStepThatTookAScan) {
  point_map::PointMap map;
  const auto ports = portsOf(map);
  const auto* points = ports.output("points", kindOf<point_map::PointMap>());
  ASSERT_NE(points, nullptr);
  Settings settings;
  map.configure(settings);
  map.execute();
  EXPECT_EQ(points->get(), nullptr);

  LaserScan scan;
  scan.stamp = stampFromNanoseconds(1000000000);
  scan.beams = {{0.0F, 2.0F}};
  Motion motion;
  motion.start = stampFromNanoseconds(0);
  motion.end = stampFromNanoseconds(2000000000);
  motion.covariance = Eigen::Matrix3d::Identity() * 1e-6;
  map.set(motion);
  map.set(FilterPose::of(scan.stamp, Pose2()));
  map.set(scan);
  map.execute();
  EXPECT_EQ(points->get(), map.isBusy() ? &map : nullptr);
  EXPECT_TRUE(map.isBusy());
}

TEST(FramesConfig, RefusesLimitsOfJumpsThatAreNone) {
  FramesConfig frames;
  frames.jump_limit = -0.1;
  EXPECT_TRUE(oneSays(faultsOf([&] { validate(frames); }), {"frames.jump_limit", ">= 0"}));
  frames.jump_limit = std::nan("");
  EXPECT_TRUE(oneSays(faultsOf([&] { validate(frames); }), {"frames.jump_limit", ">= 0"}));
  frames.jump_limit = 0.5;
  frames.jump_limit_heading = 0.0;
  EXPECT_TRUE(oneSays(faultsOf([&] { validate(frames); }), {"frames.jump_limit_heading", "> 0"}));
  frames.jump_limit_heading = 0.1;
  EXPECT_TRUE(faultsOf([&] { validate(frames); }).empty());
}

}  // namespace
}  // namespace slam
