// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/backend_contract.hpp"

namespace slam::test {

TEST(ScanToy, TakesInScansAndNoMotion) {
  DrivenBackend backend({"scan_toy", "scan_toy", {}});
  EXPECT_TRUE(backend.inputs().takes<LaserScan>());
  EXPECT_EQ(backend.inputs().ports().inputs().size(), 1U);
  EXPECT_EQ(backend.find<LandmarkMapper>(), nullptr);
  EXPECT_EQ(backend.find<GridMapper>(), nullptr);
}

TEST(ScanToy, GoesOnAtItsVelocityWhereAScanTellsNothing) {
  DrivenBackend backend({"scan_toy", "scan_toy", {}});
  RoomDrive drive(1);
  for (int i = 0; i < 20; ++i) {
    backend.inputs().set(drive.next().scan);
    backend.execute();
  }
  const auto before = backend->pose();
  auto step = drive.next();
  step.scan.beams.clear();
  backend.inputs().set(step.scan);
  EXPECT_FALSE(backend->execute().isOk());
  EXPECT_EQ(backend->counters()["coasted"], 1U);
  EXPECT_LT((backend->pose().pose.position() - step.truth.position()).norm(), 0.05);
  EXPECT_GT(backend->pose().covariance(0, 0), 2 * before.covariance(0, 0));
}

TEST(ScanToy, AddsNoKeyScansWhereItOnlyLocalises) {
  DrivenBackend mapping({"scan_toy", "scan_toy", {}});
  DrivenBackend localising({"scan_toy", "scan_toy", {"scan_toy.mode=localization"}});
  mapping.run(1, 30);
  localising.run(1, 30);
  EXPECT_GT(figureOf(*mapping, "key scans"), 3.0);
  EXPECT_EQ(figureOf(*localising, "key scans"), 1.0);
}

INSTANTIATE_BACKEND_CONTRACTS(ScanToy, (std::vector<Variant>{{"scan_toy", "scan_toy", {}}}));

}  // namespace slam::test
