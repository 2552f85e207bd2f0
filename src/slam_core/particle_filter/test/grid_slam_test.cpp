// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/particle_filter/test/filter_in_a_room.hpp"

namespace slam::particle_filter {
namespace {

TEST(GridSlam, MapsARoomAndStaysOnIt) {
  const auto filter = made();
  RoomDrive drive(1);
  EXPECT_LT(run(*filter, drive, 2 * kLap), 0.1);
  ASSERT_TRUE(as<GridMapper>(*filter).grid());
  EXPECT_GT(test::shareOnWalls(*as<GridMapper>(*filter).grid(), drive.room()), 0.8);
}

/// What a robot file says of the wheels counts beside what scans say of them.
TEST(GridSlam, ComesRoundWithARobotFileThatIsWrongByTenInEitherDirection) {
  for (const double factor : {0.01, 100.0}) {
    const auto filter = made();
    RoomDrive drive(2);
    for (int i = 0; i < 2 * kLap; ++i) {
      auto step = drive.next();
      if (i > 0) step.motion.covariance *= factor;
      EXPECT_EQ(take(*filter, step).message, "");
      EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.1) << i;
    }
  }
}

TEST(GridSlam, TheThesissProposalFromTheMotionAloneWorksToo) {
  ScanConfig scan;
  scan.proposal = ScanConfig::Proposal::kMotion;
  scan.weighting = ScanConfig::Weighting::kLikelihood;
  PfConfig config = gridConfig();
  config.particles = 200;
  const auto filter = made(config, scan);
  RoomDrive drive(2);
  EXPECT_LT(run(*filter, drive, kLap), 0.5);
}

TEST(GridSlam, IsBetterThanItsOdometry) {
  RoomDrive drive(3);
  const auto filter = made();
  Pose2 odometry;
  double odometry_worst = 0.0, worst = 0.0;
  for (int i = 0; i < 2 * kLap; ++i) {
    const auto step = drive.next();
    take(*filter, step);
    odometry = odometry * step.motion.increment;
    const auto off = [&](const Pose2& pose) {
      return (pose.position() - step.truth.position()).norm();
    };
    odometry_worst = std::max(odometry_worst, off(odometry));
    worst = std::max(worst, off(filter->pose().pose));
  }
  EXPECT_LT(worst, 0.3 * odometry_worst);
}

TEST(GridSlam, GivesTheSameBitsForAnyNumberOfThreads) {
  std::vector<std::vector<StampedPose>> paths;
  std::vector<OccupancyGrid> grids;
  for (const int threads : {1, 2, 4}) {
    auto config = gridConfig();
    config.threads = threads;
    const auto filter = made(config);
    RoomDrive drive(4);
    run(*filter, drive, kLap);
    paths.push_back(as<PathReviser>(*filter).path());
    grids.push_back(*as<GridMapper>(*filter).grid());
  }
  for (int k = 1; k < 3; ++k) {
    ASSERT_EQ(paths[k].size(), paths[0].size());
    for (std::size_t i = 0; i < paths[0].size(); ++i)
      ASSERT_EQ(paths[k][i].pose.vector(), paths[0][i].pose.vector());
    EXPECT_EQ(grids[k].cells, grids[0].cells);
  }
}

TEST(GridSlam, ScansCorrectTheMotionBetweenUpdatesWithoutTouchingParticles) {
  const auto filter = made();
  RoomDrive drive(5);
  run(*filter, drive, 1);
  const auto poses_held = filter->particleSet().memory().paths.posesInUse();
  const auto revision = as<GridMapper>(*filter).gridRevision();
  for (int i = 0; i < 2; ++i) {
    const auto before = filter->pose();
    const auto particle = filter->particleSet()[3].pose;
    auto step = drive.next();
    step.motion.increment = step.motion.increment * Pose2(0.05, 0.0, 0.05);  // it slips
    take(*filter, step);
    EXPECT_EQ(filter->particleSet()[3].pose.vector(), particle.vector());
    const Pose2 error = step.truth.between(filter->pose().pose);
    EXPECT_LT(error.position().norm(), 0.03);
    EXPECT_LT(std::abs(error.theta()), 0.02);
    EXPECT_GT(filter->pose().covariance(0, 0), before.covariance(0, 0));
  }
  EXPECT_EQ(filter->particleSet().memory().paths.posesInUse(), poses_held);
  EXPECT_EQ(as<GridMapper>(*filter).gridRevision(), revision);
  run(*filter, drive, 3);
  EXPECT_GT(as<GridMapper>(*filter).gridRevision(), revision);
  EXPECT_EQ(as<PathReviser>(*filter).path().size(), 6u) << "a line for each scan, used or not";
}

TEST(GridSlam, NeverTellsARevisionOfTheGridTwice) {
  const auto filter = made();
  std::uint64_t last = 0;
  for (int begun = 0; begun < 3; ++begun) {
    RoomDrive drive(6);
    for (int i = 0; i < 20; ++i) {
      const auto cells = as<GridMapper>(*filter).grid()->cells;
      take(*filter, drive.next());
      EXPECT_GE(as<GridMapper>(*filter).gridRevision(), last);
      if (as<GridMapper>(*filter).grid()->cells != cells) {
        EXPECT_GT(as<GridMapper>(*filter).gridRevision(), last);
      }
      last = as<GridMapper>(*filter).gridRevision();
    }
    filter->reset();
    EXPECT_GT(as<GridMapper>(*filter).gridRevision(), last) << "the grid is empty now";
    last = as<GridMapper>(*filter).gridRevision();
  }
}

TEST(GridSlam, TakesScansWithAnotherNumberOfBeamsEmptyOnesAndSuchWithoutMotion) {
  const auto filter = made();
  RoomDrive drive(7);
  for (int i = 0; i < kLap; ++i) {
    drive.beams = i % 3 == 0 ? 361 : 91;
    auto step = drive.next();
    if (i % 5 == 4) step.scan.beams.clear();
    EXPECT_EQ(take(*filter, step).message, "");
    step.scan.stamp += std::chrono::milliseconds(1);
    give(step.scan, *filter);  // the same once more, nothing between them
    EXPECT_EQ(filter->execute().message, "");
    EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.1) << i;
  }
}

TEST(GridSlam, UpdatesWithEveryScanWhereToldSoAlsoWithoutMotion) {
  ScanConfig every;
  every.update_distance = 0.0;
  const auto filter = made(gridConfig(), every);
  RoomDrive drive(8);
  auto step = drive.next();
  const auto revision = as<GridMapper>(*filter).gridRevision();
  for (int i = 0; i < 20; ++i) {
    if (i == 0) give(step.motion, *filter);
    step.scan.stamp += std::chrono::milliseconds(100);
    give(step.scan, *filter);
    EXPECT_EQ(filter->execute().message, "");
  }
  EXPECT_EQ(as<GridMapper>(*filter).gridRevision(), revision + 20);
  EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.05);
}

TEST(GridSlam, SurvivesBeamsThatAreNoNumbers) {
  const auto filter = made();
  RoomDrive drive(9);
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = INFINITY;
  for (int i = 0; i < kLap; ++i) {
    auto step = drive.next();
    for (std::size_t k = 0; k < step.scan.beams.size(); k += 7) {
      step.scan.beams[k].range = k % 2 == 0 ? nan : inf;
      step.scan.beams[k].bearing = k % 3 == 0 ? nan : step.scan.beams[k].bearing;
    }
    take(*filter, step);
    ASSERT_TRUE(filter->pose().pose.isFinite());
    EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.1) << i;
  }
}

TEST(GridSlam, SaysWhenTheMapIsTooLargeAndGoesOn) {
  grid_map::GridMapConfig small;
  small.largest_area = 20.0;
  const auto filter = made(gridConfig(), {}, small);
  RoomDrive drive(10);
  EXPECT_TRUE(test::oneSays({take(*filter, drive.next()).message},
                            {"beyond the largest grid map", "raise grid_map.largest_area"}));
  for (int i = 0; i < 50; ++i) take(*filter, drive.next());
  EXPECT_TRUE(filter->pose().pose.isFinite());
  EXPECT_GT(filter->counters()["beams_beyond_map"], 0u);
}

TEST(GridSlam, SaysWhenThereIsNotEnoughMemoryAndKeepsTheMap) {
  grid_map::GridMapConfig small;
  small.largest_memory = 4.0;
  const auto filter = made(gridConfig(), {}, small);
  RoomDrive drive(11);
  std::vector<std::string> sentences;
  for (int i = 0; i < kLap; ++i) sentences.push_back(take(*filter, drive.next()).message);
  EXPECT_TRUE(test::oneSays(sentences, {"grid_map.largest_memory", "lower pf.particles"}));
  EXPECT_LE(filter->particleSet().memory().grids.bytes(), 4e6);
  EXPECT_TRUE(filter->pose().pose.isFinite());
}

TEST(GridSlam, LocalisesInALoadedGridOfAnotherResolution) {
  grid_map::GridMapConfig coarse;
  coarse.resolution = 0.08;
  const auto mapper = made(gridConfig(), {}, coarse);
  RoomDrive first(12);
  run(*mapper, first, kLap);
  const auto map = as<MapKeeper>(*mapper).state();
  ASSERT_TRUE(map.grid);

  auto config = gridConfig();
  config.mode = BackendMode::kLocalization;
  config.particles = 50;
  const auto filter = made(config);
  RoomDrive drive(13);
  EXPECT_TRUE(test::oneSays({take(*filter, drive.next()).message}, {"no map to localise in"}));
  as<MapKeeper>(*filter).set(map);
  filter->set(PoseEstimate{Pose2(0.2, 0.05, 0.1), 0.02 * Eigen::Matrix3d::Identity()});
  filter->execute();
  const auto shown = as<GridMapper>(*filter).grid()->cells;
  const auto revision = as<GridMapper>(*filter).gridRevision();
  run(*filter, drive, 20);
  EXPECT_LT(run(*filter, drive, kLap), 0.12);
  EXPECT_EQ(as<GridMapper>(*filter).grid()->cells, shown) << "it stays as it was loaded";
  EXPECT_EQ(as<GridMapper>(*filter).gridRevision(), revision);
}

/// Nothing is mapped yet, so that the first scan tells nothing of the pose.
TEST(GridSlam, WhatIsToldOfThePoseCountsOnce) {
  auto config = gridConfig();
  config.particles = 2000;
  ScanConfig scan;
  scan.proposal = ScanConfig::Proposal::kMotion;
  const auto filter = made(config, scan);
  const Eigen::Matrix3d told = Eigen::Vector3d(0.04, 0.01, 0.01).asDiagonal();
  filter->set(PoseEstimate{Pose2(1, 2, 0.5), told});
  RoomDrive drive(16);
  take(*filter, drive.next());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& particle : as<PoseSampler>(*filter).particles()) {
    const Eigen::Vector3d deviation = particle.vector() - Eigen::Vector3d(1, 2, 0.5);
    spread += deviation * deviation.transpose() / config.particles;
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(spread(i, i), told(i, i), 0.15 * told(i, i)) << i;
}

TEST(GridSlam, GoesOnWithAMapThatWasSavedInTheMiddle) {
  const auto filter = made();
  RoomDrive drive(14);
  run(*filter, drive, kLap);
  const auto saved = as<MapKeeper>(*filter).state();
  const auto next = made();
  as<MapKeeper>(*next).set(saved);
  EXPECT_EQ(next->execute().message, "");
  EXPECT_LT(run(*next, drive, kLap), 0.12);
  EXPECT_GT(test::shareOnWalls(*as<GridMapper>(*next).grid(), drive.room()), 0.75);
}

TEST(GridSlam, TellsOfALoadedGridThatIsNone) {
  const auto filter = made();
  MapState state;
  state.robot.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  state.grid.emplace();
  state.grid->resolution = -1.0;
  as<MapKeeper>(*filter).set(state);
  EXPECT_TRUE(
      test::oneSays({filter->execute().message}, {"grid map cannot be used", "resolution"}));
  RoomDrive drive(15);
  EXPECT_LT(run(*filter, drive, 30), 0.1);
}

TEST(GridSlam, ParticlesCarryBothMapsAndLandmarksWeighIn) {
  const auto filter = made();
  RoomDrive drive(16);
  const Eigen::Vector2d landmark(2.0, -1.0);  // from the first pose
  for (int i = 0; i < 2 * kLap; ++i) {
    auto step = drive.next();
    give(step.motion, *filter);
    LandmarkObservationArray seen;
    seen.stamp = step.scan.stamp;
    if (i % 3 == 0) seen.observations.push_back(drive.sight(7, landmark));
    give(seen, *filter);
    EXPECT_EQ(filter->execute().message, "");
    give(step.scan, *filter);  // of the same stamp
    EXPECT_EQ(filter->execute().message, "");
    EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.1) << i;
  }
  ASSERT_EQ(as<LandmarkMapper>(*filter).landmarks().size(), 1u);
  EXPECT_LT((as<LandmarkMapper>(*filter).landmarks()[0].position - landmark).norm(), 0.05);
  EXPECT_GT(test::shareOnWalls(*as<GridMapper>(*filter).grid(), drive.room()), 0.8);
  const auto path = as<PathReviser>(*filter).path();
  EXPECT_EQ(path.size(), 2u * kLap) << "one line for each stamp";
}

TEST(GridSlam, StartsAfreshWithReset) {
  const auto filter = made();
  RoomDrive first(17);
  run(*filter, first, 40);
  const auto before = as<PathReviser>(*filter).path();
  filter->reset();
  EXPECT_TRUE(as<GridMapper>(*filter).grid()->cells.empty());
  EXPECT_EQ(filter->particleSet().memory().grids.tilesInUse(), 0u);
  RoomDrive again(17);
  run(*filter, again, 40);
  ASSERT_EQ(as<PathReviser>(*filter).path().size(), before.size());
  EXPECT_EQ(as<PathReviser>(*filter).path().back().pose.vector(), before.back().pose.vector());
}

TEST(GridSlam, WithoutAGridItWantsNoScans) {
  FastSlam filter;
  filter.configure(PfConfig());
  EXPECT_EQ(capabilitiesOf(filter).find<GridMapper>(), nullptr);
  EXPECT_THROW(give(LaserScan(), filter), std::logic_error);
}

TEST(GridSlam, RefusesParametersThatMakeNoGrid) {
  FastSlam filter;
  as<MapChooser>(filter).useMap(MapKind::kGrid);
  grid_map::GridMapConfig grid;
  ScanConfig scan;
  grid.resolution = 0.0;
  grid.sigma = 10.0;
  grid.hit_probability = 0.4;
  scan.outlier = 0.0;
  const auto faults = test::faultsOf([&] { filter.configure(gridConfig(), grid, scan); });
  EXPECT_EQ(faults.size(), 4u);
  EXPECT_TRUE(test::oneSays(faults, {"grid_map.resolution", "0 is not allowed"}));
  EXPECT_TRUE(test::oneSays(faults, {"grid_map.sigma", "10 is not allowed"}));
  EXPECT_TRUE(test::oneSays(faults, {"scan_matching.outlier", "0 is not allowed"}));
}

}  // namespace
}  // namespace slam::particle_filter
