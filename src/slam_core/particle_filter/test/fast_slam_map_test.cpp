// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"
#include "slam_core/product/landmark_file.hpp"

namespace slam::particle_filter {
namespace {

using test::SimulatedWorld;

template <class Filter>
Pose2 run(Filter& filter, SimulatedWorld& world, int steps) {
  Pose2 truth;
  for (int i = 0; i < steps; ++i) {
    const auto step = world.next();
    give(step.motion, filter);
    give(step.observations, filter);
    filter.execute();
    truth = step.truth;
  }
  return truth;
}

template <class Component, class Config>
std::unique_ptr<Component> configured(const Config& config) {
  auto component = std::make_unique<Component>();
  component->configure(config);
  return component;
}

PfConfig localization() {
  PfConfig config;
  config.mode = BackendMode::kLocalization;
  return config;
}

/// A mapped world, through a landmark file.
template <class Filter>
MapState savedBy(Filter& filter) {
  SimulatedWorld world(8);
  run(filter, world, 150);
  const test::TemporaryFolder folder;
  saveLandmarks(folder / "landmarks.yaml", {"map", {}, as<MapKeeper>(filter).state()});
  return loadLandmarks(folder / "landmarks.yaml", "map").map;
}

const PoseEstimate kStart{Pose2(), 1e-4 * Eigen::Matrix3d::Identity()};

TEST(FastSlamMap, OfTheEkfIsOneToLocaliseIn) {
  const auto map = savedBy(*configured<ekf::EkfSlam>(ekf::EkfConfig()));
  const auto filter = configured<FastSlam>(localization());
  as<MapKeeper>(*filter).set(map);
  filter->set(kStart);
  SimulatedWorld world(9);
  const auto truth = run(*filter, world, 60);
  EXPECT_GT(as<LandmarkMapper>(*filter).statistics().used, 0);
  EXPECT_LT((filter->pose().pose.position() - truth.position()).norm(), 0.2);
  const auto after = as<LandmarkMapper>(*filter).landmarks();
  ASSERT_EQ(after.size(), map.landmarks.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].position, map.landmarks[i].position);
    EXPECT_TRUE(after[i].covariance.isApprox(map.landmarks[i].covariance, 1e-12))
        << "not inflated: the file has the joint covariance";
  }
}

TEST(FastSlamMap, IsOneForTheEkfToLocaliseIn) {
  const auto map = savedBy(*configured<FastSlam>(PfConfig()));
  ekf::EkfConfig config;
  config.mode = BackendMode::kLocalization;
  const auto filter = configured<ekf::EkfSlam>(config);
  as<MapKeeper>(*filter).set(map);
  filter->set(kStart);
  SimulatedWorld world(9);
  const auto truth = run(*filter, world, 60);
  EXPECT_GT(as<LandmarkMapper>(*filter).statistics().used, 0);
  EXPECT_LT((filter->pose().pose.position() - truth.position()).norm(), 0.2);
}

TEST(FastSlamMap, IsInflatedWhereItHasNoJointCovariance) {
  const auto map = savedBy(*configured<FastSlam>(PfConfig()));
  PfConfig config;
  config.load_inflation = 3.0;
  const auto filter = configured<FastSlam>(config);
  as<MapKeeper>(*filter).set(map);
  filter->execute();
  const auto loaded = as<LandmarkMapper>(*filter).landmarks();
  for (std::size_t i = 0; i < loaded.size(); ++i)
    EXPECT_TRUE(loaded[i].covariance.isApprox(9 * map.landmarks[i].covariance, 1e-12));
  EXPECT_EQ(filter->pose().covariance, map.robot.covariance);
}

TEST(FastSlamMap, IsSavedAsUnsureAsItsLandmarksAreToOneAnother) {
  const auto filter = configured<FastSlam>(PfConfig());
  SimulatedWorld world(8);
  run(*filter, world, 100);
  const auto told = as<LandmarkMapper>(*filter).landmarks(),
             saved = as<MapKeeper>(*filter).state().landmarks;
  const auto& particles = filter->particleSet();
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(saved[i].position, told[i].position);
    EXPECT_LT(saved[i].covariance.trace(), 1.000001 * told[i].covariance.trace());
  }
  double spread = 0.0, own = 0.0;
  for (std::size_t slot = 0; slot < told.size(); ++slot)
    own += particles[particles.best()].map[slot].covariance().trace();
  for (const auto& landmark : saved) spread += landmark.covariance.trace();
  EXPECT_GT(spread, own) << "the particles' disagreement belongs to it";
  EXPECT_EQ(as<MapKeeper>(*filter).state().joint_covariance.size(), 0);
}

TEST(FastSlamMap, OfOneCopyIsSharedByAllParticlesThatOnlyLocalise) {
  const auto filter = configured<FastSlam>(localization());
  as<MapKeeper>(*filter).set(savedBy(*configured<ekf::EkfSlam>(ekf::EkfConfig())));
  SimulatedWorld world(9);
  run(*filter, world, 60);
  EXPECT_EQ(filter->particleSet().memory().maps.leavesInUse(), 4u) << "16 landmarks, 4 a leaf";
}

TEST(FastSlamMap, LeavesOutAndCountsStrangersInLocalization) {
  const auto filter = configured<FastSlam>(localization());
  give(LandmarkObservationArray{}, *filter);
  EXPECT_TRUE(test::oneSays({filter->execute().message}, {"no map", "load one"}));
  SimulatedWorld world(9);
  run(*filter, world, 1);
  EXPECT_TRUE(as<LandmarkMapper>(*filter).landmarks().empty());
  EXPECT_GT(as<LandmarkMapper>(*filter).statistics().unknown, 0);
  EXPECT_EQ(filter->counters()["not_in_map"],
            std::uint64_t(as<LandmarkMapper>(*filter).statistics().unknown));
}

TEST(FastSlamMap, IsKeptWhenTheRobotIsRedrawnExactlyThere) {
  const auto filter = configured<FastSlam>(PfConfig());
  SimulatedWorld world(8);
  run(*filter, world, 50);
  const PoseEstimate there{Pose2(1, 2, 3), Eigen::Vector3d(0.25, 0.25, 0.07).asDiagonal()};
  filter->set(there);
  filter->execute();
  EXPECT_EQ(filter->pose().pose.vector(), there.pose.vector());
  EXPECT_EQ(filter->pose().covariance, there.covariance);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const auto particles = as<PoseSampler>(*filter).particles();
  for (const auto& pose : particles)
    mean += there.pose.between(pose).vector() / double(particles.size());
  EXPECT_LT(mean.norm(), 0.15);
}

}  // namespace
}  // namespace slam::particle_filter
