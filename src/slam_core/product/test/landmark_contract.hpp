// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/product/test/covariance_check.hpp"
#include "slam_core/product/test/driven_backend.hpp"

// What a back-end promises whose map has landmarks. It is driven by motion and observations alone:
// the contract is not for one that needs more, such as scans.

namespace slam::test {

class LandmarkContract : public ContractTest {
 protected:
  static void take(DrivenBackend& backend, const SimulatedStep& step) {
    backend.inputs().offer(step.motion);
    backend.inputs().set(step.observations);
    backend.execute();
  }
  static void run(DrivenBackend& backend, SimulatedWorld world, int steps) {
    for (int i = 0; i < steps; ++i) take(backend, world.next());
  }
  static LandmarkMap mapOf(const DrivenBackend& backend) {
    return backend.as<LandmarkMapper>().landmarks();
  }
  static UpdateStatistics statisticsOf(const DrivenBackend& backend) {
    return backend.as<LandmarkMapper>().statistics();
  }
};
// A back-end without landmarks has none of these tests.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LandmarkContract);

TEST_P(LandmarkContract, ConvergesToAStaticWorld) {
  constexpr int kWorlds = 3;
  double pose_error = 0.0, landmark_error = 0.0;
  for (std::uint64_t seed = 1; seed <= kWorlds; ++seed) {
    auto backend = make();
    SimulatedWorld world(seed);
    Pose2 truth;
    for (int i = 0; i < 400; ++i) {  // three laps
      const auto step = world.next();
      take(backend, step);
      truth = step.truth;
    }
    pose_error += (backend->pose().pose.position() - truth.position()).norm() / kWorlds;
    const auto map = mapOf(backend);
    ASSERT_EQ(map.size(), world.landmarks().size());
    const double count = double(map.size()) * kWorlds;
    for (const auto& landmark : map)
      landmark_error += (landmark.position - world.landmarks().at(landmark.id)).norm() / count;
  }
  EXPECT_LT(pose_error, 0.1);
  EXPECT_LT(landmark_error, 0.08);
}

TEST_P(LandmarkContract, KeepsItsCovariancesPositiveDefiniteAtEveryStep) {
  auto backend = make();
  SimulatedWorld world(2);
  for (int i = 0; i < 200; ++i) {
    take(backend, world.next());
    ASSERT_TRUE(isSymmetricPositiveDefinite(backend->pose().covariance)) << "step " << i;
    for (const auto& landmark : mapOf(backend))
      ASSERT_TRUE(isSymmetricPositiveDefinite(landmark.covariance)) << "step " << i;
  }
}

TEST_P(LandmarkContract, HasNoLandmarksAfterReset) {
  auto backend = make();
  run(backend, SimulatedWorld(4), 50);
  EXPECT_FALSE(mapOf(backend).empty());
  backend->reset();
  EXPECT_TRUE(mapOf(backend).empty());
}

TEST_P(LandmarkContract, IsAsWrongAsItSays) {
  constexpr int kSeeds = 50;
  double nees = 0.0, nis = 0.0;
  int dof = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    auto backend = make();
    SimulatedWorld world(1000 + seed);
    Pose2 truth;
    for (int i = 0; i < 40; ++i) {
      const auto step = world.next();
      take(backend, step);
      truth = step.truth;
      nis += statisticsOf(backend).nis;
      dof += statisticsOf(backend).nis_dof;
    }
    nees += test::nees(truth, backend->pose().pose, backend->pose().covariance) / kSeeds;
  }
  // 0.0005 and 0.9995 quantiles of chi-square with 150 degrees of freedom, over 50
  EXPECT_GT(nees, 1.99);
  EXPECT_LT(nees, 4.27);
  ASSERT_GT(dof, 5000);
  EXPECT_NEAR(nis / dof, 1.0, 3.3 * std::sqrt(2.0 / dof) + 0.02);
}

TEST_P(LandmarkContract, TellsWhatBecameOfItsObservations) {
  auto backend = make();
  SimulatedWorld world(6);
  auto step = world.next();
  LandmarkObservation stranger = step.observations.observations.at(0);
  stranger.id = kUnknownId;
  step.observations.observations.insert(step.observations.observations.begin(), stranger);
  const int seen = int(step.observations.observations.size());
  take(backend, step);
  auto statistics = statisticsOf(backend);
  EXPECT_EQ(statistics.unknown, 1);
  EXPECT_EQ(statistics.added, seen - 1);
  EXPECT_EQ(statistics.landmarks, seen - 1);
  EXPECT_EQ(statistics.nis_dof, 0);
  step = world.next();
  take(backend, step);
  statistics = statisticsOf(backend);
  EXPECT_EQ(statistics.used + statistics.gated + statistics.added,
            int(step.observations.observations.size()));
  backend.inputs().offer(world.next().motion);
  backend->execute();
  EXPECT_EQ(statisticsOf(backend).used, 0) << "of the last step only";
}

TEST_P(LandmarkContract, KeepsTheMapWhenTheRobotIsRedrawn) {
  auto backend = make();
  run(backend, SimulatedWorld(9), 80);
  const auto map = mapOf(backend);
  backend->set(PoseEstimate{Pose2(1, 2, 0.5), 0.01 * Eigen::Matrix3d::Identity()});
  backend.execute();
  EXPECT_LT((backend->pose().pose.vector() - Eigen::Vector3d(1, 2, 0.5)).norm(), 0.1);
  const auto after = mapOf(backend);
  ASSERT_EQ(after.size(), map.size());
  for (std::size_t i = 0; i < map.size(); ++i) EXPECT_EQ(after[i].position, map[i].position);
}

/// Those of the variants that this contract is for.
inline std::vector<Variant> mappingLandmarksAlone(const std::vector<Variant>& variants) {
  std::vector<Variant> able;
  for (const auto& variant : offering<LandmarkMapper>(variants)) {
    DrivenBackend backend(variant);
    const auto& inputs = backend.inputs().ports().inputs();
    const bool needs_more = std::any_of(inputs.begin(), inputs.end(), [](const auto& input) {
      return input.is_mandatory && input.kind != kindOf<Motion>() &&
             input.kind != kindOf<LandmarkObservationArray>();
    });
    if (!needs_more && backend.inputs().takes<LandmarkObservationArray>()) able.push_back(variant);
  }
  return able;
}

}  // namespace slam::test
