// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/meta_coordinator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/product_run.hpp"

namespace slam {
namespace {

using test::oneSays;

std::vector<std::string> faultsOfProduct(const std::string& product, const std::string& robot = "",
                                         const std::vector<std::string>& overrides = {}) {
  return test::faultsOf([&] {
    Settings settings({"product.yaml", YAML::Load(product)}, {"robot.yaml", YAML::Load(robot)},
                      overrides);
    MetaCoordinator().configure(settings);
  });
}

TEST(MetaCoordinatorConfig, TakesTheDefaultsOfAnEmptyProduct) {
  EXPECT_TRUE(faultsOfProduct("").empty());
}

TEST(MetaCoordinatorConfig, ListsTheFaultsOfAllSectionsAtOnce) {
  const auto faults = faultsOfProduct(
      "{version: 1, source_timeout: 0, colour: red, ekf: {gate_probability: 1}, sonar: {}}",
      "{version: 1, wheel_odometry: {alpha1: -1}, landmark_sensor: {sigma_range: 0}, frames: {mpa: "
      "world}}",
      {"ekf.mode=slamm"});
  EXPECT_EQ(faults.size(), 8u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"source_timeout", "> 0"}));
  EXPECT_TRUE(oneSays(faults, {"colour", "unknown"}));
  EXPECT_TRUE(oneSays(faults, {"ekf.gate_probability", "(0, 1)"}));
  EXPECT_TRUE(oneSays(faults, {"ekf.mode", "did you mean 'slam'"}));
  EXPECT_TRUE(oneSays(faults, {"wheel_odometry.alpha1", ">= 0"}));
  EXPECT_TRUE(oneSays(faults, {"landmark_sensor.sigma_range", "> 0"}));
  EXPECT_TRUE(oneSays(faults, {"frames.mpa", "did you mean 'map'"}));
  EXPECT_TRUE(oneSays(faults, {"section sonar", "product.yaml"}));
}

TEST(MetaCoordinatorConfig, NamesTheNearestComponent) {
  const auto faults = faultsOfProduct("{version: 1, backend: efk, odometry: weel, ekf: {}}");
  EXPECT_EQ(faults.size(), 2u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"back-end 'efk'", "there are", "did you mean 'ekf'"}));
  EXPECT_TRUE(oneSays(faults, {"odometry source 'weel'", "did you mean 'wheel'"}));
}

TEST(MetaCoordinatorConfig, FindsASectionWithATypo) {
  EXPECT_TRUE(oneSays(faultsOfProduct("{version: 1, efk: {mode: slam}}"),
                      {"section efk", "did you mean 'ekf'"}));
}

TEST(MetaCoordinatorConfig, RefusesAGridThatTheBackEndDoesNotMake) {
  const auto faults = faultsOfProduct("{version: 1, backend: ekf, map: grid}");
  EXPECT_EQ(faults.size(), 1u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"'ekf' makes no grid", "non-parametric",
                               "choose backend: graph or grid or pf", "map: landmarks"}));
  EXPECT_TRUE(
      faultsOfProduct("{version: 1, backend: pf, map: grid, grid_map: {resolution: 0.1}}").empty());
}

TEST(MetaCoordinatorConfig, KnowsTheLasersSectionOfEveryRobot) {
  EXPECT_TRUE(
      faultsOfProduct("", "{version: 1, laser: {sensor_pose: [0, 0, 0, 0, 0, 0]}}").empty());
  const auto faults = faultsOfProduct("", "{version: 1, laser: {sensor_pose: [1], range_max: -1}}");
  EXPECT_TRUE(oneSays(faults, {"laser.range_max", ">= 0"})) << join(faults, "\n");
}

TEST(MetaCoordinatorConfig, RefusesFramesThatAreNone) {
  const auto faults =
      faultsOfProduct("", "{version: 1, frames: {map: /map, odom: '', base: base_link}}");
  EXPECT_EQ(faults.size(), 2u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"frames.map", "'/map'", "slash"}));
  EXPECT_TRUE(oneSays(faults, {"frames.odom", "empty"}));
}

TEST(MetaCoordinatorConfig, RefusesOneNameForTwoFrames) {
  EXPECT_TRUE(oneSays(faultsOfProduct("", "{version: 1, frames: {map: odom}}"), {"must differ"}));
}

TEST(MetaCoordinatorConfig, SaysWhyALibraryDoesNotLoad) {
  EXPECT_TRUE(oneSays(faultsOfProduct("{version: 1, libraries: [libslam_nowhere.so]}"),
                      {"libslam_nowhere.so", "cannot open shared object file"}));
}

OdometrySample sampleAt(Stamp stamp, const Pose2& pose) {
  OdometrySample sample;
  sample.stamp = stamp;
  sample.pose = pose;
  sample.odometry_frame = "odom";
  sample.base_frame = "base_link";
  return sample;
}

class MetaCoordinatorRun : public testing::Test, protected test::ProductRun {
 protected:
  void SetUp() override {
    configure({"wheel_odometry.alpha1=2e-4", "wheel_odometry.alpha2=0",
               "wheel_odometry.alpha3=1e-4",
               "wheel_odometry.alpha4=0"});  // with the noise of the simulated world
  }
};

TEST_F(MetaCoordinatorRun, LeadsRawOdometryAndObservationsToAMap) {
  test::SimulatedWorld world(4);
  Pose2 truth;
  for (int i = 0; i < 100; ++i) {
    const auto step = world.next();
    truth = step.truth;
    if (i == 0) coordinator.set(sampleAt(step.motion.start, step.motion.odometry_start));
    coordinator.set(sampleAt(step.motion.end, step.motion.odometry_end));
    coordinator.set(step.observations);
    drain();
  }
  EXPECT_EQ(reports.size(), 100u);
  EXPECT_TRUE(sentences.empty());
  EXPECT_EQ(coordinator.dropped(), 0u);
  const auto pose = coordinator.estimator().backend().pose().pose;
  EXPECT_LT((pose.position() - truth.position()).norm(), 0.3);
}

/// A drive of 300 steps whose odometry samples go through a change. @return where it ends
template <class Change>
Pose2 driveWith(test::ProductRun& run, const Change& change) {
  test::SimulatedWorld world(4);
  Pose2 truth;
  for (int i = 0; i < 300; ++i) {
    const auto step = world.next();
    truth = step.truth;
    const Pose2 begin(20, -10, 1);  // of the odometry
    if (i == 0)
      run.coordinator.set(sampleAt(step.motion.start, begin * step.motion.odometry_start));
    auto sample = sampleAt(step.motion.end, begin * step.motion.odometry_end);
    change(i, sample);
    run.coordinator.set(sample);
    run.coordinator.set(step.observations);
    run.drain();
  }
  return truth;
}

TEST_F(MetaCoordinatorRun, LosesNothingOfARunToThreeOdometryMessagesStampedAhead) {
  const auto truth = driveWith(*this, [](int i, auto& sample) {
    if (i >= 100 && i < 103) sample.stamp += std::chrono::seconds(100);
  });
  EXPECT_GE(reports.size(), 298u);
  EXPECT_GT(coordinator.dropped(), 0u);
  const auto pose = coordinator.estimator().backend().pose().pose;
  EXPECT_LT((pose.position() - truth.position()).norm(), 0.3);
}

TEST_F(MetaCoordinatorRun, GoesOnWhereTheDriverOfTheOdometryWasRestarted) {
  Pose2 restart;
  const auto truth = driveWith(*this, [&](int i, auto& sample) {
    if (i == 100) restart = *sample.pose;
    if (i >= 100) sample.pose = restart.between(*sample.pose);
  });
  EXPECT_GE(reports.size(), 298u);
  EXPECT_EQ(coordinator.counters()["odometry_pose_jump"], 1u);
  EXPECT_EQ(sentences.size(), 2u) << join(sentences, "\n");
  const auto estimate = coordinator.estimator().backend().pose();
  EXPECT_LT((estimate.pose.position() - truth.position()).norm(), 0.3);
  EXPECT_LT(test::nees(truth, estimate.pose, estimate.covariance), 16.0);
}

TEST_F(MetaCoordinatorRun, IsNotMovedByOneOdometryMessageThatIsOff) {
  for (const double off : {1e6, 1e300}) {
    SetUp();
    reports.clear();
    const auto truth = driveWith(*this, [&](int i, auto& sample) {
      if (i == 100) sample.pose = Pose2(off, 0, 0);
    });
    EXPECT_GE(reports.size(), 298u);
    EXPECT_EQ(coordinator.dropped(), 1u);
    const auto pose = coordinator.estimator().backend().pose().pose;
    EXPECT_LT((pose.position() - truth.position()).norm(), 0.3) << off;
  }
}

TEST(MetaCoordinatorFrames, AreThoseOfTheRobotFileWhereTheDataNameNone) {
  Settings settings({}, {"robot.yaml", YAML::Load("{version: 1, frames: {odom: wheels}}")}, {});
  MetaCoordinator coordinator;
  coordinator.configure(settings);
  auto sample = sampleAt(stampFromNanoseconds(1000000000), Pose2());
  for (const auto* name : {"", "wheels", ""}) {  // the same frame: no change that loses motion
    sample.odometry_frame = name;
    sample.base_frame.clear();
    coordinator.set(sample);
    sample.stamp += std::chrono::milliseconds(100);
  }
  LandmarkObservationArray nothing_seen;
  nothing_seen.stamp = stampFromNanoseconds(1150000000);
  coordinator.set(nothing_seen);
  coordinator.execute();
  ASSERT_TRUE(coordinator.estimator().report().has_value());
  EXPECT_EQ(coordinator.estimator().report()->odometry_frame, "wheels");
  EXPECT_EQ(coordinator.estimator().report()->base_frame, "base_link");
  EXPECT_TRUE(coordinator.counters().all().empty());
}

TEST_F(MetaCoordinatorRun, PassesOnTheWarningsAndCountsOfTheFrontEnd) {
  const auto start = stampFromNanoseconds(1000000000);
  coordinator.set(sampleAt(start, Pose2()));
  coordinator.set(sampleAt(start, Pose2()));
  drain();
  EXPECT_TRUE(oneSays(sentences, {"odometry is not newer"}));
  EXPECT_EQ(coordinator.counters()["odometry_late"], 1u);
  EXPECT_EQ(coordinator.dropped(), 1u);
  drain();
  EXPECT_EQ(sentences.size(), 1u) << "said once";
  coordinator.reset();
  EXPECT_TRUE(coordinator.counters().all().empty());
}

}  // namespace
}  // namespace slam
