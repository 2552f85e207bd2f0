// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/product/test/correction_contract.hpp"
#include "slam_core/product/test/covariance_check.hpp"
#include "slam_core/product/test/graph_contract.hpp"
#include "slam_core/product/test/grid_contract.hpp"
#include "slam_core/product/test/landmark_contract.hpp"
#include "slam_core/product/test/landmark_remover_contract.hpp"
#include "slam_core/product/test/map_keeper_contract.hpp"

// What every back-end promises, and the contracts of what it offers beyond that. A program that
// includes this tests the back-ends that are linked into it; those that a contract is not for are
// left out of it:
//   INSTANTIATE_BACKEND_CONTRACTS(Mine, (std::vector<Variant>{{"mine", "mine", {}}}));

/// @param variants a vector of Variant
#define INSTANTIATE_BACKEND_CONTRACTS(name, variants)                                             \
  INSTANTIATE_TEST_SUITE_P(name, BackendContract, testing::ValuesIn(variants), variantName);      \
  INSTANTIATE_TEST_SUITE_P(name, LandmarkContract,                                                \
                           testing::ValuesIn(mappingLandmarksAlone(variants)), variantName);      \
  INSTANTIATE_TEST_SUITE_P(name, LandmarkRemoverContract,                                         \
                           testing::ValuesIn(removingLandmarks(variants)), variantName);          \
  INSTANTIATE_TEST_SUITE_P(name, MapKeeperContract,                                               \
                           testing::ValuesIn(offering<MapKeeper>(variants)), variantName);        \
  INSTANTIATE_TEST_SUITE_P(name, CorrectionContract,                                              \
                           testing::ValuesIn(offering<CorrectionReporter>(variants)),             \
                           variantName);                                                          \
  INSTANTIATE_TEST_SUITE_P(name, GraphContract,                                                   \
                           testing::ValuesIn(offering<GraphReporter>(variants)), variantName);    \
  INSTANTIATE_TEST_SUITE_P(name, EventContract,                                                   \
                           testing::ValuesIn(offering<EventReporter>(variants)), variantName);    \
  INSTANTIATE_TEST_SUITE_P(name, GridContract, testing::ValuesIn(offering<GridMapper>(variants)), \
                           variantName)

namespace slam::test {

class BackendContract : public ContractTest {
 protected:
  static void expectSameLandmarks(const LandmarkMap& a, const LandmarkMap& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].id, b[i].id);
      EXPECT_EQ(a[i].position, b[i].position);
      EXPECT_EQ(a[i].covariance, b[i].covariance);
    }
  }
  static void expectSameGrid(const GridMapper& a, const GridMapper& b) {
    const auto grid_a = a.grid(), grid_b = b.grid();
    ASSERT_EQ(grid_a.has_value(), grid_b.has_value());
    if (!grid_a) return;
    EXPECT_EQ(grid_a->cells, grid_b->cells);
  }
  static void expectSamePath(const PathReviser& a, const PathReviser& b) {
    const auto path_a = a.path(), path_b = b.path();
    ASSERT_EQ(path_a.size(), path_b.size());
    for (std::size_t i = 0; i < path_a.size(); ++i)
      EXPECT_EQ(path_a[i].pose.vector(), path_b[i].pose.vector());
  }
  static void expectSameParticles(const PoseSampler& a, const PoseSampler& b) {
    const auto particles_a = a.particles(), particles_b = b.particles();
    ASSERT_EQ(particles_a.size(), particles_b.size());
    for (std::size_t i = 0; i < particles_a.size(); ++i)
      EXPECT_EQ(particles_a[i].vector(), particles_b[i].vector());
  }
  /// Of all that they offer.
  static void expectSameBits(const DrivenBackend& a, const DrivenBackend& b) {
    EXPECT_EQ(a->pose().pose.vector(), b->pose().pose.vector());
    EXPECT_EQ(a->pose().covariance, b->pose().covariance);
    if (a.find<LandmarkMapper>())
      expectSameLandmarks(a.as<LandmarkMapper>().landmarks(), b.as<LandmarkMapper>().landmarks());
    if (a.find<MapKeeper>()) {
      const auto state_a = a.as<MapKeeper>().state(), state_b = b.as<MapKeeper>().state();
      EXPECT_EQ(state_a.joint_covariance, state_b.joint_covariance);
      expectSameLandmarks(state_a.landmarks, state_b.landmarks);
    }
    if (a.find<GridMapper>()) expectSameGrid(a.as<GridMapper>(), b.as<GridMapper>());
    if (a.find<PathReviser>()) expectSamePath(a.as<PathReviser>(), b.as<PathReviser>());
    if (a.find<PoseSampler>()) expectSameParticles(a.as<PoseSampler>(), b.as<PoseSampler>());
  }
};

TEST_P(BackendContract, StaysWithTheRobot) {
  constexpr int kDrives = 3;
  double error = 0.0;
  for (std::uint64_t seed = 1; seed <= kDrives; ++seed) {
    auto backend = make();
    const auto drive = backend.drive(seed);
    Pose2 truth;
    for (int i = 0; i < drive->stepsOfALap(); ++i) truth = backend.step(*drive);
    error += (backend->pose().pose.position() - truth.position()).norm() / kDrives;
  }
  EXPECT_LT(error, 0.1);
}

TEST_P(BackendContract, KeepsThePosesCovariancePositiveDefiniteAtEveryStep) {
  auto backend = make();
  const auto drive = backend.drive(2);
  for (int i = 0; i < 200; ++i) {
    backend.step(*drive);
    ASSERT_TRUE(isSymmetricPositiveDefinite(backend->pose().covariance)) << "step " << i;
  }
}

TEST_P(BackendContract, GivesTheSameBitsForTheSameInput) {
  auto first = make(), second = make();
  first.run(3, 100);
  second.run(3, 100);
  expectSameBits(first, second);
}

TEST_P(BackendContract, IsFreshAfterReset) {
  auto fresh = make(), used = make();
  used.run(4, 50);
  used.drive(5)->give(used.inputs());  // an input that waits must be forgotten, too
  used->reset();
  EXPECT_TRUE(used->counters().all().empty());
  fresh.run(3, 60);
  used.run(3, 60);
  expectSameBits(fresh, used);
}

TEST_P(BackendContract, IsFreshAfterConfigure) {
  auto fresh = make(), used = make();
  used.run(4, 50);
  used.configure();
  fresh.run(3, 60);
  used.run(3, 60);
  expectSameBits(fresh, used);
}

TEST_P(BackendContract, GoesWhereTheRobotIsRedrawn) {
  auto backend = make();
  backend.run(9, 80);
  backend->set(PoseEstimate{Pose2(1, 2, 0.5), 0.01 * Eigen::Matrix3d::Identity()});
  backend.execute();
  EXPECT_LT((backend->pose().pose.vector() - Eigen::Vector3d(1, 2, 0.5)).norm(), 0.1);
}

}  // namespace slam::test
