// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

namespace slam::particle_filter {
namespace {

using test::SimulatedWorld;

Pose2 run(FastSlam& filter, SimulatedWorld& world, int steps) {
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

std::unique_ptr<FastSlam> landmarkFilter(const PfConfig& config = {}) {
  auto filter = std::make_unique<FastSlam>();
  filter->configure(config);
  return filter;
}

TEST(FastSlamTrouble, ARobotPutElsewhereIsReportedLostAndFoundWithANewPose) {
  const auto filter = landmarkFilter();
  SimulatedWorld world(11);
  run(*filter, world, 125);  // a lap
  const auto before = filter->counters()["gated"];
  std::vector<std::string> sentences;
  Pose2 truth;
  for (int i = 0; i < 60; ++i) {
    const auto step = world.next();
    if (i >= 40) give(step.motion, *filter);  // carried for 8 m before that
    if (i >= 40) give(step.observations, *filter);
    if (i < 40) continue;
    const auto status = filter->execute();
    if (!status.isOk()) sentences.push_back(status.message);
    truth = step.truth;
  }
  EXPECT_TRUE(test::oneSays(sentences, {"less likely", "lost", "initial pose"}));
  EXPECT_GT(filter->counters()["gated"], before);
  filter->set(PoseEstimate{truth, 1e-2 * Eigen::Matrix3d::Identity()});
  filter->execute();
  for (int i = 0; i < 20; ++i) {
    const auto step = world.next();
    give(step.motion, *filter);
    give(step.observations, *filter);
    EXPECT_TRUE(filter->execute().isOk()) << "step " << i;
    truth = step.truth;
  }
  EXPECT_LT((filter->pose().pose.position() - truth.position()).norm(), 0.3);
}

TEST(FastSlamTrouble, AnIdSeenByChanceOnceFarAwayDoesNoHarm) {
  const auto with = landmarkFilter();
  SimulatedWorld world(12);
  Pose2 truth;
  int gated_by_chance = 0;  // the gate is wrong about one observation in ten thousand
  for (int i = 0; i < 125; ++i) {
    auto step = world.next();
    auto stray = step.observations.observations.front();
    if (i == 20) {  // an id of the map, read from a poster at the end of the hall
      stray.range = 80.0;
      step.observations.observations.front() = stray;
    }
    if (i == 40) {  // an id that nobody has ever seen, and never again
      stray.id = 999;
      stray.range = 80.0;
      step.observations.observations.push_back(stray);
    }
    give(step.motion, *with);
    give(step.observations, *with);
    EXPECT_TRUE(with->execute().isOk());
    if (i == 20) {
      EXPECT_EQ(as<LandmarkMapper>(*with).statistics().gated, 1);
    } else {
      gated_by_chance += as<LandmarkMapper>(*with).statistics().gated;
    }
    truth = step.truth;
  }
  EXPECT_LE(gated_by_chance, 2);
  EXPECT_LT((with->pose().pose.position() - truth.position()).norm(), 0.2);
  for (const auto& landmark : as<LandmarkMapper>(*with).landmarks()) {
    if (landmark.id == 999) continue;
    EXPECT_LT((landmark.position - world.landmarks().at(landmark.id)).norm(), 0.3) << landmark.id;
  }
}

TEST(FastSlamTrouble, WeightsThatAllVanishAreMadeEqualAndReported) {
  const auto filter = landmarkFilter();
  SimulatedWorld world(13);
  run(*filter, world, 20);
  auto step = world.next();
  for (auto& z : step.observations.observations)  // as good as infinite: no number comes of it
    z.covariance = 1e308 * Eigen::Matrix2d::Identity();
  give(step.motion, *filter);
  give(step.observations, *filter);
  EXPECT_TRUE(test::oneSays({filter->execute().message}, {"all weights vanished", "goes on"}));
  EXPECT_EQ(filter->counters()["weight_underflow"], 1u);
  const auto truth = run(*filter, world, 20);
  EXPECT_TRUE(isCovariance(filter->pose().covariance));
  EXPECT_LT((filter->pose().pose.position() - truth.position()).norm(), 0.2);
}

}  // namespace
}  // namespace slam::particle_filter
