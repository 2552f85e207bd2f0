// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/product/test/covariance_check.hpp"
#include "slam_core/product/test/driven_component.hpp"

// Every odometry source that takes in the wheels' odometry, commands or a laser's scans keeps this
// contract. A program that includes this file tests the sources that are linked into it:
//   INSTANTIATE_ODOMETRY_CONTRACT(Mine, (std::vector<RoleVariant>{{"mine", "mine"}}));

/// @param variants a vector of RoleVariant
#define INSTANTIATE_ODOMETRY_CONTRACT(name, variants) \
  INSTANTIATE_TEST_SUITE_P(name, OdometryContract, testing::ValuesIn(variants), roleVariantName)

namespace slam::test {

class OdometryContract : public testing::TestWithParam<RoleVariant> {
 protected:
  using Driven = DrivenComponent<OdometrySource>;

  static std::vector<Motion> motionsOf(Driven& source, std::uint64_t seed, int steps) {
    std::vector<Motion> motions;
    source.run(seed, steps, [&] {
      if (source->motion()) motions.push_back(*source->motion());
    });
    return motions;
  }
  static void expectSameBits(const std::vector<Motion>& a, const std::vector<Motion>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].end, b[i].end);
      EXPECT_EQ(a[i].increment.vector(), b[i].increment.vector());
      EXPECT_EQ(a[i].covariance, b[i].covariance);
    }
  }
};

TEST_P(OdometryContract, MakesMotions) {
  Driven source(GetParam());
  const auto& outputs = source.inputs().ports().outputs();
  ASSERT_EQ(outputs.size(), 1U);
  EXPECT_EQ(outputs.front().name, "motion");
  EXPECT_EQ(outputs.front().kind, kindOf<Motion>());
}

TEST_P(OdometryContract, MotionsFollowOneAnotherWithoutAFault) {
  Driven source(GetParam());
  const auto motions = motionsOf(source, 1, 100);
  ASSERT_GT(motions.size(), 50U);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    ASSERT_EQ(faultOf(motions[i]), "");
    ASSERT_TRUE(isSymmetricPositiveDefinite(motions[i].covariance)) << "motion " << i;
    ASSERT_LT(motions[i].start, motions[i].end);
    if (i == 0) continue;
    ASSERT_EQ(motions[i].start, motions[i - 1].end);
    ASSERT_EQ(motions[i].sequence, motions[i - 1].sequence + 1);
  }
}

TEST_P(OdometryContract, SumsUpToTheWayOfTheRobot) {
  Driven source(GetParam());
  Pose2 sum;
  for (const auto& motion : motionsOf(source, 2, 60)) sum = sum * motion.increment;
  RoomDrive drive(2);
  Pose2 truth;
  for (int i = 0; i < 60; ++i) truth = drive.next().truth;
  EXPECT_LT((sum.position() - truth.position()).norm(), 0.1 * 60 * drive.way_of_step);
}

TEST_P(OdometryContract, GivesTheSameBitsForTheSameInput) {
  Driven first(GetParam()), second(GetParam());
  expectSameBits(motionsOf(first, 3, 60), motionsOf(second, 3, 60));
}

TEST_P(OdometryContract, IsFreshAfterResetAndAfterConfigure) {
  RestartedComponents<OdometrySource> sources(GetParam());
  const auto expected = motionsOf(sources.fresh, 3, 40);
  expectSameBits(expected, motionsOf(sources.reset, 3, 40));
  expectSameBits(expected, motionsOf(sources.configured, 3, 40));
}

}  // namespace slam::test
