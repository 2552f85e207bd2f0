// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::ekf {
namespace {

using test::SimulatedWorld;

void run(EkfSlam& ekf, SimulatedWorld& world, int steps) {
  for (int i = 0; i < steps; ++i) {
    const auto step = world.next();
    ekf.set(step.motion);
    ekf.set(step.observations);
    ekf.execute();
  }
}

MapState mappedWorld() {
  EkfSlam ekf;
  ekf.configure(EkfConfig());
  SimulatedWorld world(8);
  run(ekf, world, 150);
  return as<MapKeeper>(ekf).state();
}

EkfConfig localization() {
  EkfConfig config;
  config.mode = BackendMode::kLocalization;
  return config;
}

Eigen::MatrixXd mapBlock(const MapState& state) {
  const auto size = state.joint_covariance.rows() - 3;
  return state.joint_covariance.bottomRightCorner(size, size);
}

/// The world's true map with small errors, as a survey gives it.
MapState surveyedMap(const SimulatedWorld& world, double sigma, RandomStream random) {
  MapState map;
  map.robot.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix2d P = sigma * sigma * Eigen::Matrix2d::Identity();
  for (const auto& [id, position] : world.landmarks()) {
    const Eigen::Vector2d error(sigma * random.gaussian(), sigma * random.gaussian());
    map.landmarks.push_back({id, position + error, P});
  }
  return map;
}

TEST(EkfMap, IsKeptBitForBitInLocalization) {
  const auto map = mappedWorld();
  EkfSlam ekf;
  ekf.configure(localization());
  as<MapKeeper>(ekf).set(map);
  SimulatedWorld world(9);
  PoseEstimate start{Pose2(), 1e-4 * Eigen::Matrix3d::Identity()};
  ekf.set(start);
  run(ekf, world, 60);
  EXPECT_GT(as<LandmarkMapper>(ekf).statistics().used, 0);
  const auto after = as<MapKeeper>(ekf).state();
  ASSERT_EQ(after.landmarks.size(), map.landmarks.size());
  for (std::size_t i = 0; i < map.landmarks.size(); ++i)
    EXPECT_EQ(after.landmarks[i].position, map.landmarks[i].position);
  EXPECT_EQ(mapBlock(after), mapBlock(map));
}

TEST(EkfMap, LeavesOutAndCountsStrangersInLocalization) {
  EkfSlam ekf;
  ekf.configure(localization());
  SimulatedWorld world(9);
  run(ekf, world, 1);
  EXPECT_TRUE(as<LandmarkMapper>(ekf).landmarks().empty());
  EXPECT_GT(as<LandmarkMapper>(ekf).statistics().unknown, 0);
  EXPECT_EQ(ekf.counters()["not_in_map"],
            std::uint64_t(as<LandmarkMapper>(ekf).statistics().unknown));
}

TEST(EkfMap, IsAskedForWhereThereIsNoneToLocalizeIn) {
  EkfSlam ekf;
  ekf.configure(localization());
  ekf.set(LandmarkObservationArray{});
  const auto status = ekf.execute();
  EXPECT_EQ(status.level, Status::Level::kWarning);
  EXPECT_NE(status.message.find("load one"), std::string::npos) << status.message;
}

TEST(EkfMap, LocalizesAsWellAsItsCovarianceSays) {
  constexpr int kSeeds = 60;
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    auto config = localization();
    config.load_inflation = 1.0;
    EkfSlam ekf;
    ekf.configure(config);
    SimulatedWorld world(100 + seed);
    as<MapKeeper>(ekf).set(surveyedMap(world, 0.05, RandomStream(7, seed)));
    Pose2 truth;
    for (int i = 0; i < 80; ++i) {
      const auto step = world.next();
      ekf.set(step.motion);
      ekf.set(step.observations);
      ekf.execute();
      truth = step.truth;
    }
    sum += test::nees(truth, ekf.pose().pose, ekf.pose().covariance);
  }
  // 0.0005 and 0.9995 quantiles of chi-square with 180 degrees of freedom, over 60
  EXPECT_GT(sum / kSeeds, 2.06);
  EXPECT_LT(sum / kSeeds, 4.14);
}

TEST(EkfMap, LosesItsCorrelationsToTheRobotWhenThatIsRedrawn) {
  EkfSlam ekf;
  ekf.configure(EkfConfig());
  SimulatedWorld world(8);
  run(ekf, world, 50);
  const auto before = as<MapKeeper>(ekf).state();
  ASSERT_GT(before.joint_covariance.topRightCorner(3, 4).norm(), 0.0);
  const PoseEstimate there{Pose2(1, 2, 3), Eigen::Vector3d(0.25, 0.25, 0.07).asDiagonal()};
  ekf.set(there);
  ekf.execute();
  const auto after = as<MapKeeper>(ekf).state();
  EXPECT_EQ(after.robot.pose.vector(), there.pose.vector());
  EXPECT_EQ(after.robot.covariance, there.covariance);
  const auto columns = after.joint_covariance.cols() - 3;
  EXPECT_TRUE(after.joint_covariance.topRightCorner(3, columns).isZero(0.0));
  EXPECT_EQ(mapBlock(after), mapBlock(before));
}

/// What rviz or a script sends that knows nothing of where the robot is.
TEST(EkfMap, StaysFiniteWhateverTheSigmaOfAnInitialPose) {
  for (const double sigma : {1e4, 1e6, 1e100, 1e150}) {
    EkfSlam ekf;
    ekf.configure(EkfConfig());
    ekf.set(PoseEstimate{Pose2(), sigma * sigma * Eigen::Matrix3d::Identity()});
    SimulatedWorld world(3);
    run(ekf, world, 200);
    EXPECT_TRUE(ekf.pose().pose.isFinite()) << sigma;
    EXPECT_TRUE(as<MapKeeper>(ekf).state().joint_covariance.allFinite()) << sigma;
    EXPECT_EQ(as<LandmarkMapper>(ekf).landmarks().size(), world.landmarks().size());
    EXPECT_GT(as<LandmarkMapper>(ekf).statistics().used, 0) << sigma;
  }
}

TEST(EkfMap, ComesBackWholeFromItsState) {
  const auto map = mappedWorld();
  EkfSlam ekf;
  ekf.configure(EkfConfig());
  as<MapKeeper>(ekf).set(map);
  ekf.execute();
  EXPECT_EQ(as<MapKeeper>(ekf).state().joint_covariance, map.joint_covariance);
  EXPECT_EQ(ekf.pose().pose.vector(), map.robot.pose.vector());
}

TEST(EkfMap, IsInflatedWhereItHasNoJointCovariance) {
  auto map = mappedWorld();
  map.joint_covariance.resize(0, 0);
  EkfConfig config;
  config.load_inflation = 3.0;
  EkfSlam ekf;
  ekf.configure(config);
  as<MapKeeper>(ekf).set(map);
  ekf.execute();
  const auto loaded = as<LandmarkMapper>(ekf).landmarks();
  for (std::size_t i = 0; i < loaded.size(); ++i)
    EXPECT_TRUE(loaded[i].covariance.isApprox(9 * map.landmarks[i].covariance, 1e-12));
  EXPECT_EQ(ekf.pose().covariance, map.robot.covariance);
}

TEST(EkfMap, IsSavedWithoutItsJointCovarianceWhereThatWouldBeTooLarge) {
  const auto map = mappedWorld();
  EkfConfig config;
  config.joint_limit = int(map.landmarks.size()) - 1;
  EkfSlam ekf;
  ekf.configure(config);
  as<MapKeeper>(ekf).set(map);
  ekf.execute();
  const auto state = as<MapKeeper>(ekf).state();
  EXPECT_EQ(state.joint_covariance.size(), 0);
  ASSERT_EQ(state.landmarks.size(), map.landmarks.size());
  EXPECT_EQ(state.landmarks[0].covariance, map.landmarks[0].covariance);
}

TEST(EkfMap, IsEmptyAgainAfterReset) {
  EkfSlam ekf;
  ekf.configure(EkfConfig());
  as<MapKeeper>(ekf).set(mappedWorld());
  ekf.execute();
  ekf.reset();
  ekf.execute();
  EXPECT_TRUE(as<LandmarkMapper>(ekf).landmarks().empty());
  EXPECT_EQ(ekf.pose().pose.vector(), Eigen::Vector3d::Zero());
}

TEST(EkfConfigTest, RefusesWhatMakesNoFilter) {
  EkfConfig config;
  config.gate_probability = 0.0;
  config.initial_sigma_heading = -1;
  config.load_inflation = 0.5;
  config.filter = "uncented";
  config.linearization = "texbook";
  const auto faults = test::faultsOf([&] { EkfSlam().configure(config); });
  EXPECT_EQ(faults.size(), 5u);
  EXPECT_TRUE(test::oneSays(faults, {"ekf.filter", "did you mean 'unscented'"}));
  EXPECT_TRUE(test::oneSays(faults, {"ekf.gate_probability", "(0, 1)"}));
  EXPECT_TRUE(test::oneSays(faults, {"ekf.linearization", "did you mean 'textbook'"}));
}

TEST(EkfConfigTest, RefusesAFirstPoseOfWhichNothingIsKnown) {
  EkfConfig config;
  config.initial_sigma_heading = 3.15;
  config.initial_sigma_position = 1001.0;
  const auto faults = test::faultsOf([&] { EkfSlam().configure(config); });
  EXPECT_EQ(faults.size(), 2u);
  EXPECT_TRUE(test::oneSays(faults, {"ekf.initial_sigma_heading", "3.15", "(0, 3.14159"}));
  EXPECT_TRUE(test::oneSays(faults, {"ekf.initial_sigma_position", "(0, 1000]"}));
}

}  // namespace
}  // namespace slam::ekf
