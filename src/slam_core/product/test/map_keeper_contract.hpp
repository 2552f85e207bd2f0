// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/product/map_files.hpp"
#include "slam_core/product/test/covariance_check.hpp"
#include "slam_core/product/test/driven_backend.hpp"

// What a back-end promises whose map and pose can be saved, and taken up again.

namespace slam::test {

class MapKeeperContract : public ContractTest {
 protected:
  static MapState stateOf(const DrivenBackend& backend) { return backend.as<MapKeeper>().state(); }
  /// Through the files that a product writes.
  static MapState saved(const DrivenBackend& backend) {
    const TemporaryFolder folder;
    saveMap(folder / "map.yaml", {"map", {}, stateOf(backend)});
    return loadMap(folder / "map.yaml", "map", backend.find<GridMapper>() != nullptr).map;
  }
  static void expectSamePlaces(const LandmarkMap& a, const LandmarkMap& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].id, b[i].id);
      EXPECT_EQ(a[i].position, b[i].position);
    }
  }
};
// A back-end that keeps no map has none of these tests.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MapKeeperContract);

TEST_P(MapKeeperContract, KeepsTheJointCovariancePositiveDefiniteAtEveryStep) {
  auto backend = make();
  const auto drive = backend.drive(2);
  for (int i = 0; i < 200; ++i) {
    backend.step(*drive);
    const auto joint = stateOf(backend).joint_covariance;
    ASSERT_TRUE(joint.size() == 0 || isSymmetricPositiveDefinite(joint)) << "step " << i;
  }
}

TEST_P(MapKeeperContract, ComesBackFromItsFiles) {
  auto first = make(), loaded = make();
  first.run(7, 80);
  loaded.run(8, 20);  // what it knew is replaced
  loaded.as<MapKeeper>().set(saved(first));
  loaded.execute();
  EXPECT_LT((loaded->pose().pose.vector() - first->pose().pose.vector()).norm(), 1e-12);
  expectSamePlaces(stateOf(first).landmarks, stateOf(loaded).landmarks);
}

TEST_P(MapKeeperContract, GoesOnInAMapThatCameBack) {
  auto first = make(), loaded = make();
  const auto drive = first.drive(7);
  for (int i = 0; i < drive->stepsOfALap(); ++i) first.step(*drive);
  loaded.as<MapKeeper>().set(saved(first));
  loaded.execute();
  Pose2 truth;
  for (int i = 0; i < 40; ++i) truth = loaded.step(*drive);
  EXPECT_LT((loaded->pose().pose.position() - truth.position()).norm(), 0.3);
}

}  // namespace slam::test
