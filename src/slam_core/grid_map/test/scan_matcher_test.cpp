// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_matcher.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "slam_core/grid_map/coarse_table.hpp"
#include "slam_core/grid_map/scan_insertion.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::grid_map {
namespace {

/// A map of the room from known poses.
class ScanMatching : public testing::Test {
 protected:
  ScanMatching() {
    for (int i = 0; i < 145; ++i) {
      const auto step = drive.next();
      insertScan(model, pointsOf(step.scan, model, 0.05), step.truth, map);
      truth = step.truth;
    }
    scan = pointsOf(drive.next().scan, model, 0.05);  // one that is not in the map
    truth = truth * Pose2::exp({0.1, 0.0, 0.1 / 2.3});
  }

  MatchObjective objective(const Pose2& offset, double sigma) const {
    const Eigen::Vector3d variances(sigma * sigma, sigma * sigma, sigma * sigma);
    return {likelihood, map, scan, truth * offset, variances.asDiagonal()};
  }
  void expectTruth(const Pose2& found) const {
    const Pose2 error = truth.between(found);
    EXPECT_LT(error.position().norm(), 0.015);
    EXPECT_LT(std::abs(error.theta()), 0.006);
  }

  BeamModel model;
  ScanLikelihood likelihood{0.01, 0.2};
  GridMap::Memory memory;
  GridMap map{memory};
  test::RoomDrive drive{3};
  ScanPoints scan;
  Pose2 truth;
};

TEST_F(ScanMatching, AScanIsMostLikelyWhereItWasTaken) {
  const double best = likelihood.log(map, scan, truth);
  EXPECT_LT(best, 0.0);
  for (const auto& offset : {Pose2(0.06, 0, 0), Pose2(0, -0.06, 0), Pose2(0, 0, 0.03),
                             Pose2(-0.3, 0.2, 0), Pose2(0, 0, M_PI), Pose2(100, 0, 0)})
    EXPECT_LT(likelihood.log(map, scan, truth * offset), best);
}

TEST_F(ScanMatching, NoPlaceOnAMapIsAsUnlikelyAsAllOutliers) {
  const double none = likelihood.log(map, scan, Pose2(1000, 1000, 0));
  EXPECT_NEAR(none, 0.2 * std::log(0.01 / 1.01) * static_cast<double>(scan.ends.size()), 1e-3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {nan, 1e300, -1e15})
    EXPECT_EQ(likelihood.log(map, scan, Pose2(x, 0, 0)), none);
}

TEST_F(ScanMatching, HillClimbingFindsBackFromWhatOdometryErrsBy) {
  const HillClimbing climbing({});
  for (const auto& offset : {Pose2(0.08, 0.05, 0.04), Pose2(-0.06, -0.08, -0.05), Pose2()})
    expectTruth(climbing.match(objective(offset, 0.1)).pose);
}

TEST_F(ScanMatching, CorrelativeMatchingFindsBackFromWhereClimbingDoesNot) {
  const Pose2 offset(0.9, -0.8, 0.5);
  const HillClimbing climbing({});
  const auto lost = climbing.match(objective(offset, 1.0));
  EXPECT_GT(truth.between(lost.pose).position().norm(), 0.1);
  const CorrelativeMatching correlative({1.0, 0.6}, {});
  const auto found = correlative.match(objective(offset, 1.0));
  expectTruth(found.pose);
  EXPECT_GT(found.log_value, lost.log_value);
}

TEST_F(ScanMatching, CorrelativeMatchingIsNeverWorseThanClimbing) {
  RandomStream random(1, 0);
  for (int i = 0; i < 10; ++i) {
    const Pose2 offset(0.2 * random.gaussian(), 0.2 * random.gaussian(), 0.1 * random.gaussian());
    const auto posed = objective(offset, 0.3);
    const auto climbed = HillClimbing({}).match(posed);
    const auto found = CorrelativeMatching({0.3, 0.2}, {}).match(posed);
    EXPECT_GE(found.log_value, climbed.log_value);
  }
}

TEST_F(ScanMatching, CorrelativeMatchingSearchesAsFarToEverySide) {
  const CorrelativeMatching correlative({0.0, 0.0}, {});
  for (const double x : {-0.3, 0.3})
    for (const double y : {-0.3, 0.3}) {
      const auto posed = objective(Pose2(x, y, 0.0), 1.0);
      const auto climbed = HillClimbing({}).match(posed);
      EXPECT_EQ(correlative.match(posed).pose.vector(), climbed.pose.vector()) << x << " " << y;
    }
}

TEST_F(ScanMatching, TheMotionDecidesWhereTheScanDoesNot) {
  ScanPoints one = scan;
  one.ends.resize(1);
  const Eigen::Vector3d sharp(1e-8, 1e-8, 1e-8);
  const Pose2 prior = truth * Pose2(0.3, 0.3, 0.3);
  const MatchObjective posed(likelihood, map, one, prior, sharp.asDiagonal());
  for (const auto& match :
       {HillClimbing({}).match(posed), CorrelativeMatching({}, {}).match(posed)})
    EXPECT_LT(prior.between(match.pose).position().norm(), 0.005);
}

TEST_F(ScanMatching, AScanWithoutEndsStaysWhereMotionHasIt) {
  ScanPoints nothing = scan;
  nothing.ends.clear();
  const Eigen::Vector3d variances(0.01, 0.01, 0.01);
  const MatchObjective posed(likelihood, map, nothing, truth, variances.asDiagonal());
  EXPECT_EQ(HillClimbing({}).match(posed).pose.vector(), truth.vector());
  EXPECT_EQ(CorrelativeMatching({}, {}).match(posed).pose.vector(), truth.vector());
}

TEST_F(ScanMatching, TheCoarseTableIsNowhereBelowAnyCellThatAShiftLeadsTo) {
  const CellIndex least{-90, -20}, most{120, 130};
  const CoarseTable table(map, least, most);
  RandomStream random(2, 0);
  const auto below = [&](std::int32_t n) {
    return static_cast<std::int32_t>(random.uniform() * n);
  };
  for (int i = 0; i < 20000; ++i) {
    const CellIndex cell{least.x + below(most.x - least.x), least.y + below(most.y - least.y)};
    const CellIndex shifted{cell.x + below(CoarseTable::kSize), cell.y + below(CoarseTable::kSize)};
    const auto* const tile = map.tile(shifted);
    if (tile == nullptr) continue;
    ASSERT_GE(table.at(cell), tile->likelihood[Tile::at(shifted)]);
  }
}

}  // namespace
}  // namespace slam::grid_map
