// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/landmark_file.hpp"

// What every back-end promises. A program that includes this and instantiates the suite tests the
// back-ends that are linked into it:
//   INSTANTIATE_TEST_SUITE_P(Mine, BackendContract, testing::Values(Variant{"mine", "mine", {}}),
//                            variantName);

namespace slam::test {

inline bool isSymmetricPositiveDefinite(const Eigen::MatrixXd& P) {
  return P.allFinite() && (P - P.transpose()).cwiseAbs().maxCoeff() < 1e-12 &&
         Eigen::LLT<Eigen::MatrixXd>(P).info() == Eigen::Success;
}

/// A back-end as it comes, or with settings that change how it works.
struct Variant {
  std::string backend, name;
  std::vector<std::string> settings;
};

inline std::string variantName(const testing::TestParamInfo<Variant>& variant) {
  return variant.param.name;
}

class BackendContract : public testing::TestWithParam<Variant> {
 protected:
  static void configure(Backend& backend) {
    Settings settings({}, {}, GetParam().settings);
    backend.configure(settings);
  }
  static std::unique_ptr<Backend> make() {
    auto backend = Registry<Backend>::instance().create(GetParam().backend);
    configure(*backend);
    return backend;
  }
  static void take(Backend& backend, const SimulatedStep& step) {
    backend.set(step.motion);
    backend.set(step.observations);
    ASSERT_TRUE(backend.execute().isOk());
  }
  static void run(Backend& backend, SimulatedWorld world, int steps) {
    for (int i = 0; i < steps; ++i) take(backend, world.next());
  }
  static void expectSameBits(const Backend& a, const Backend& b) {
    EXPECT_EQ(a.pose().pose.vector(), b.pose().pose.vector());
    EXPECT_EQ(a.pose().covariance, b.pose().covariance);
    const auto state_a = a.state(), state_b = b.state();
    EXPECT_EQ(state_a.joint_covariance, state_b.joint_covariance);
    ASSERT_EQ(state_a.landmarks.size(), state_b.landmarks.size());
    for (std::size_t i = 0; i < state_a.landmarks.size(); ++i) {
      EXPECT_EQ(state_a.landmarks[i].id, state_b.landmarks[i].id);
      EXPECT_EQ(state_a.landmarks[i].position, state_b.landmarks[i].position);
      EXPECT_EQ(state_a.landmarks[i].covariance, state_b.landmarks[i].covariance);
    }
  }
};

TEST_P(BackendContract, ConvergesToAStaticWorld) {
  constexpr int kWorlds = 3;
  double pose_error = 0.0, landmark_error = 0.0;
  for (std::uint64_t seed = 1; seed <= kWorlds; ++seed) {
    const auto backend = make();
    SimulatedWorld world(seed);
    Pose2 truth;
    for (int i = 0; i < 400; ++i) {  // three laps
      const auto step = world.next();
      take(*backend, step);
      truth = step.truth;
    }
    pose_error += (backend->pose().pose.position() - truth.position()).norm() / kWorlds;
    const auto map = backend->landmarks();
    ASSERT_EQ(map.size(), world.landmarks().size());
    const double count = double(map.size()) * kWorlds;
    for (const auto& landmark : map)
      landmark_error += (landmark.position - world.landmarks().at(landmark.id)).norm() / count;
  }
  EXPECT_LT(pose_error, 0.1);
  EXPECT_LT(landmark_error, 0.08);
}

TEST_P(BackendContract, KeepsItsCovariancesPositiveDefiniteAtEveryStep) {
  const auto backend = make();
  SimulatedWorld world(2);
  for (int i = 0; i < 200; ++i) {
    take(*backend, world.next());
    ASSERT_TRUE(isSymmetricPositiveDefinite(backend->pose().covariance)) << "step " << i;
    for (const auto& landmark : backend->landmarks())
      ASSERT_TRUE(isSymmetricPositiveDefinite(landmark.covariance)) << "step " << i;
    const auto joint = backend->state().joint_covariance;
    ASSERT_TRUE(joint.size() == 0 || isSymmetricPositiveDefinite(joint)) << "step " << i;
  }
}

TEST_P(BackendContract, GivesTheSameBitsForTheSameInput) {
  const auto first = make(), second = make();
  run(*first, SimulatedWorld(3), 100);
  run(*second, SimulatedWorld(3), 100);
  expectSameBits(*first, *second);
}

TEST_P(BackendContract, IsFreshAfterReset) {
  const auto fresh = make(), used = make();
  run(*used, SimulatedWorld(4), 50);
  SimulatedWorld other(5);
  const auto step = other.next();
  used->set(step.motion);  // an input that waits must be forgotten, too
  used->set(step.observations);
  used->reset();
  EXPECT_TRUE(used->landmarks().empty());
  EXPECT_TRUE(used->counters().all().empty());
  run(*fresh, SimulatedWorld(3), 60);
  run(*used, SimulatedWorld(3), 60);
  expectSameBits(*fresh, *used);
}

TEST_P(BackendContract, IsFreshAfterConfigure) {
  const auto fresh = make(), used = make();
  run(*used, SimulatedWorld(4), 50);
  configure(*used);
  run(*fresh, SimulatedWorld(3), 60);
  run(*used, SimulatedWorld(3), 60);
  expectSameBits(*fresh, *used);
}

TEST_P(BackendContract, IsAsWrongAsItSays) {
  constexpr int kSeeds = 50;
  double nees = 0.0, nis = 0.0;
  int dof = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto backend = make();
    SimulatedWorld world(1000 + seed);
    Pose2 truth;
    for (int i = 0; i < 40; ++i) {
      const auto step = world.next();
      take(*backend, step);
      truth = step.truth;
      nis += backend->statistics().nis;
      dof += backend->statistics().nis_dof;
    }
    nees += test::nees(truth, backend->pose().pose, backend->pose().covariance) / kSeeds;
  }
  // 0.0005 and 0.9995 quantiles of chi-square with 150 degrees of freedom, over 50
  EXPECT_GT(nees, 1.99);
  EXPECT_LT(nees, 4.27);
  ASSERT_GT(dof, 5000);
  EXPECT_NEAR(nis / dof, 1.0, 3.3 * std::sqrt(2.0 / dof) + 0.02);
}

TEST_P(BackendContract, TellsWhatBecameOfItsObservations) {
  const auto backend = make();
  SimulatedWorld world(6);
  auto step = world.next();
  LandmarkObservation stranger = step.observations.observations.at(0);
  stranger.id = kUnknownId;
  step.observations.observations.insert(step.observations.observations.begin(), stranger);
  const int seen = int(step.observations.observations.size());
  take(*backend, step);
  auto statistics = backend->statistics();
  EXPECT_EQ(statistics.unknown, 1);
  EXPECT_EQ(statistics.added, seen - 1);
  EXPECT_EQ(statistics.landmarks, seen - 1);
  EXPECT_EQ(statistics.nis_dof, 0);
  step = world.next();
  take(*backend, step);
  statistics = backend->statistics();
  EXPECT_EQ(statistics.used + statistics.gated + statistics.added,
            int(step.observations.observations.size()));
  backend->set(world.next().motion);
  backend->execute();
  EXPECT_EQ(backend->statistics().used, 0) << "of the last step only";
}

TEST_P(BackendContract, ComesBackFromItsLandmarkFile) {
  const auto saved = make(), loaded = make();
  run(*saved, SimulatedWorld(7), 80);
  const TemporaryFolder folder;
  saveLandmarks(folder / "landmarks.yaml", {"map", {}, saved->state()});
  run(*loaded, SimulatedWorld(8), 20);  // what it knew is replaced
  loaded->set(loadLandmarks(folder / "landmarks.yaml", "map").map);
  ASSERT_TRUE(loaded->execute().isOk());
  EXPECT_LT((loaded->pose().pose.vector() - saved->pose().pose.vector()).norm(), 1e-12);
  const auto a = saved->landmarks(), b = loaded->landmarks();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].position, b[i].position);
  }
}

TEST_P(BackendContract, KeepsTheMapWhenTheRobotIsRedrawn) {
  const auto backend = make();
  run(*backend, SimulatedWorld(9), 80);
  const auto map = backend->landmarks();
  backend->set(PoseEstimate{Pose2(1, 2, 0.5), 0.01 * Eigen::Matrix3d::Identity()});
  ASSERT_TRUE(backend->execute().isOk());
  EXPECT_LT((backend->pose().pose.vector() - Eigen::Vector3d(1, 2, 0.5)).norm(), 0.1);
  const auto after = backend->landmarks();
  ASSERT_EQ(after.size(), map.size());
  for (std::size_t i = 0; i < map.size(); ++i) EXPECT_EQ(after[i].position, map[i].position);
}

}  // namespace slam::test
