// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/ekf/test/ekf_variants.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::ekf {
namespace {

using test::SimulatedWorld;

constexpr int kHour = 36000;  ///< steps of 0.1 s

void expectSound(EkfSlam& ekf) {
  EXPECT_TRUE(ekf.pose().pose.isFinite());
  const auto joint = as<MapKeeper>(ekf).state().joint_covariance;
  EXPECT_TRUE(joint.allFinite());
  EXPECT_EQ(joint.llt().info(), Eigen::Success);
  for (const auto& landmark : as<LandmarkMapper>(ekf).landmarks()) {
    EXPECT_TRUE(landmark.position.allFinite());
    EXPECT_EQ(landmark.covariance.llt().info(), Eigen::Success);
  }
}

class EkfHardCases : public testing::TestWithParam<test::EkfVariant> {
 protected:
  void SetUp() override {
    auto config = test::configOf(GetParam());
    config.neighbourhood = 4;  // stretches end often
    ekf.configure(config);
  }
  Status take(const Motion& motion, const LandmarkObservationArray& observations) {
    ekf.set(motion);
    ekf.set(observations);
    return ekf.execute();
  }
  void drive(SimulatedWorld& world, int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto step = world.next();
      take(step.motion, step.observations);
      truth = step.truth;
    }
  }
  /// An hour in which nothing is seen and each motion has this variance.
  void hourOfBlindness(const Eigen::Vector3d& variance) {
    Motion motion;
    motion.covariance = variance.asDiagonal();
    for (int i = 0; i < kHour; ++i) take(motion, {});
  }
  EkfSlam ekf;
  Pose2 truth;
};

TEST_P(EkfHardCases, LandmarksThatComeBackAfterAnHourFitARobotThatHasStood) {
  SimulatedWorld world(3);
  drive(world, 150);
  hourOfBlindness({1e-8, 1e-8, 1e-9});
  expectSound(ekf);
  drive(world, 150);
  expectSound(ekf);
  EXPECT_LT((ekf.pose().pose.position() - truth.position()).norm(), 0.3);
  EXPECT_LT(test::nees(truth, ekf.pose().pose, ekf.pose().covariance), 40.0);
}

TEST_P(EkfHardCases, LandmarksThatComeBackAfterAnHourOfDrivingNeverBreakTheFilter) {
  SimulatedWorld world(4);
  drive(world, 150);
  hourOfBlindness({1e-3, 1e-3, 1e-3});  // then the heading may be anything
  expectSound(ekf);
  drive(world, 150);
  expectSound(ekf);
}

INSTANTIATE_TEST_SUITE_P(All, EkfHardCases, test::allVariants(),
                         [](const auto& variant) { return test::nameOf(variant.param); });

TEST(EkfLargeMap, OfTenThousandLandmarksIsLoadedUpdatedAndTold) {
  constexpr int kLandmarks = 10000;
  EkfSlam ekf;
  ekf.configure(EkfConfig());
  MapState map;
  map.robot.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  for (int id = 0; id < kLandmarks; ++id)
    map.landmarks.push_back(
        {id, {id % 100 - 50.5, id / 100 - 50.5}, 0.01 * Eigen::Matrix2d::Identity()});
  as<MapKeeper>(ekf).set(map);
  LandmarkObservationArray seen;
  for (const int id : {4950, 5051, 5150}) {
    LandmarkObservation z;
    z.id = id;
    const auto& m = map.landmarks[std::size_t(id)].position;
    z.range = m.norm() + 0.05;
    z.bearing = std::atan2(m.y(), m.x());
    z.covariance = Eigen::Vector2d(25e-4, 1e-4).asDiagonal();
    seen.observations.push_back(z);
  }
  Motion motion;
  motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    ekf.set(motion);
    ekf.set(seen);
    EXPECT_TRUE(ekf.execute().isOk());
  }
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().used, 3);
  const auto told = as<MapKeeper>(ekf).state();
  ASSERT_EQ(told.landmarks.size(), std::size_t(kLandmarks));
  EXPECT_EQ(told.joint_covariance.size(), 0) << "it would fill a disk";
  EXPECT_LT(told.landmarks[4950].covariance.trace(), map.landmarks[4950].covariance.trace());
  EXPECT_EQ(told.landmarks[0].position, map.landmarks[0].position);
}

}  // namespace
}  // namespace slam::ekf
