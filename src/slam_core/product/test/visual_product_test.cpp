// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/camera/image.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/product/test/product_run.hpp"

namespace slam {
namespace {

using test::faultsOfWords;
using test::oneSays;
namespace ceilings = test::ceilings;

TEST(VisualProductConfig, NamesTheOdometrySourcesThereAre) {
  EXPECT_TRUE(oneSays(faultsOfWords({"odometry=visul"}),
                      {"odometry source 'visul'", "did you mean 'visual'", "visual_wheel"}));
}

TEST(VisualProductConfig, NeedsTheCeilingsHeight) {
  for (const char* odometry : {"odometry=visual", "odometry=visual_wheel"}) {
    EXPECT_TRUE(
        oneSays(faultsOfWords({odometry}), {"ceiling_height is 0", "above 0", "robot file"}));
    EXPECT_TRUE(oneSays(faultsOfWords({odometry, "visual_odometry.ceiling_height=-1"}),
                        {"visual_odometry.ceiling_height", "-1"}));
    EXPECT_TRUE(faultsOfWords({odometry, "visual_odometry.ceiling_height=1.7"}).empty());
  }
}

TEST(VisualProductConfig, TellsAllFaultsOfItsSections) {
  const auto faults =
      faultsOfWords({"odometry=visual", "visual_odometry.features=obr",
                     "visual_odometry.max_speed=0", "ceiling_camera.sensor_pose=[1, 2]"});
  EXPECT_TRUE(oneSays(faults, {"visual_odometry.features", "orb"}));
  EXPECT_TRUE(oneSays(faults, {"visual_odometry.max_speed", "> 0"}));
}

TEST(VisualProduct, MovesByTheCeilingAndTakesNoWheels) {
  Settings settings({}, {}, {"odometry=visual", "visual_odometry.ceiling_height=1.7"});
  MetaCoordinator product;
  product.configure(settings);
  product.put("ceiling_camera", ceilings::smallCamera());
  const auto mount = ceilings::mountUp();
  product.put("ceiling_camera", mount);
  std::vector<Motion> motions;
  product.listen<Motion>("motion", [&](const Motion& motion) { motions.push_back(motion); });

  const ceilings::Ceiling ceiling;
  Stamp stamp(std::chrono::seconds(1));
  for (int i = 0; i < 5; ++i, stamp += std::chrono::milliseconds(100)) {
    OdometrySample wheels;  // of a robot that stands
    wheels.stamp = stamp;
    wheels.pose = Pose2();
    product.set(wheels);
    const auto light = ceiling.seenBy(mount, Pose2(0.05 * i, 0.0, 0.0));
    product.put("ceiling_camera",
                Image{stamp, mount.camera_frame, ceilings::exposed(light, {}, 1), ""});
  }
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[0].odometry_frame, "odom");
  EXPECT_EQ(motions[0].base_frame, "base_link");
  EXPECT_NEAR(motions.back().odometry_end.x(), 0.2, 0.004);

  LandmarkObservationArray array;
  array.stamp = stamp - std::chrono::milliseconds(150);
  product.set(array);
  EXPECT_TRUE(product.execute().isOk());
  ASSERT_TRUE(product.estimator().report());
  EXPECT_NEAR(product.estimator().report()->pose.pose.x(), 0.175, 0.004);
}

TEST(VisualProduct, WheelsLookAtNoCeiling) {
  Settings settings;
  MetaCoordinator product;
  product.configure(settings);
  product.listen<Motion>("motion", [](const Motion&) { FAIL() << "nothing comes of images"; });
  product.put("ceiling_camera", ceilings::smallCamera());
  for (int i = 1; i < 4; ++i)
    product.put("ceiling_camera",
                Image{Stamp(std::chrono::seconds(i)), "c", cv::Mat(240, 320, CV_8UC1), ""});
}

}  // namespace
}  // namespace slam
