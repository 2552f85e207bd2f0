// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_gap.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "slam_core/models/test/simulated_world.hpp"

namespace slam {
namespace {

using Bridge = MotionGap::Bridge;

std::vector<Motion> drive(int steps) {
  test::SimulatedWorld world(1);
  std::vector<Motion> all;
  for (int i = 0; i < steps; ++i) all.push_back(world.next().motion);
  return all;
}

/// @return the gap of a drive of which the first motions have come
MotionGap gapBehind(const std::vector<Motion>& all, int count = 4) {
  MotionGap gap;
  for (int i = 0; i < count; ++i) {
    auto motion = all[static_cast<std::size_t>(i)];
    gap.bridge(motion);
  }
  return gap;
}

TEST(MotionGap, LeavesAloneWhatIsComplete) {
  MotionGap gap;
  for (auto motion : drive(10)) {
    const auto start = motion.start;
    EXPECT_EQ(gap.bridge(motion), Bridge::kNone);
    EXPECT_EQ(motion.start, start);
  }
}

TEST(MotionGap, IsBridgedByWhatTheLostMotionsTellTogether) {
  const auto all = drive(60);
  MotionGap gap;
  auto first = all[4], next = all[55];
  EXPECT_EQ(gap.bridge(first), Bridge::kNone);
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  Motion expected = all[5];
  for (int i = 6; i <= 55; ++i) expected = joined(expected, all[i]);
  EXPECT_EQ(next.start, expected.start);
  EXPECT_EQ(next.end, expected.end);
  EXPECT_EQ(next.sequence, 55u);
  EXPECT_LT((next.increment.vector() - expected.increment.vector()).norm(), 1e-9);
  EXPECT_LT((next.odometry_start.vector() - expected.odometry_start.vector()).norm(), 1e-9);
  // the robot's speed and noise are constant, so that its worst increment is like all others
  EXPECT_TRUE(next.covariance.isApprox(expected.covariance, 1e-6)) << next.covariance;
}

/// After most of a lap the robot is near where it was, but has come round the circle: the shortest
/// way between the two poses would let an error of the heading lead hardly anywhere.
TEST(MotionGap, IsAsUncertainAsALongerWayMayHaveMadeIt) {
  constexpr int kFirst = 4, kNext = kFirst + 9 * test::SimulatedWorld::kLap / 10;
  const auto all = drive(kNext + 1);
  auto gap = gapBehind(all, kFirst + 1);
  auto next = all[kNext];
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  Motion expected = all[kFirst + 1];
  for (int i = kFirst + 2; i <= kNext; ++i) expected = joined(expected, all[i]);
  ASSERT_LT((next.increment.vector() - expected.increment.vector()).norm(), 1e-9);
  const Eigen::Matrix2d more = (next.covariance - expected.covariance).topLeftCorner<2, 2>();
  EXPECT_GT(more.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0)
      << next.covariance << "\n\n"
      << expected.covariance;
  EXPECT_EQ(faultOf(next), "");
}

TEST(MotionGap, OfWheelsThatHaveNotTurnedHidesNoWay) {
  const auto all = drive(20);
  auto gap = gapBehind(all);
  auto next = all[14];
  next.odometry_start = next.odometry_end = all[3].odometry_end;
  next.increment = Pose2();
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_TRUE(next.covariance.isApprox(11 * all[0].covariance, 1e-6)) << next.covariance;
}

TEST(MotionGap, OfADayIsNoFault) {
  const auto all = drive(20);
  auto gap = gapBehind(all);
  auto next = all[14];
  next.start += std::chrono::hours(24);
  next.end += std::chrono::hours(24);
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_EQ(faultOf(next), "");
}

TEST(MotionGap, IsAsUncertainAsTheWorstIncrementThatWasSeen) {
  auto all = drive(20);
  all[2].covariance *= 9.0;
  auto gap = gapBehind(all);
  Motion next = all[14];
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_GT(next.covariance(0, 0), 9.0 * 10 * all[0].covariance(0, 0));
  EXPECT_EQ(faultOf(next), "");
}

TEST(MotionGap, IsAsUncertainAsTheWorstWayAndTheWorstTurn) {
  auto all = drive(20);
  all[1].covariance.topLeftCorner<2, 2>() *= 9.0;
  all[2].covariance(2, 2) *= 9.0;  // [rad^2], not to be weighed up with [m^2]
  auto gap = gapBehind(all);
  Motion next = all[14];
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_GT(next.covariance(0, 0), 9.0 * 10 * all[0].covariance(0, 0));
  EXPECT_GT(next.covariance(2, 2), 9.0 * 10 * all[0].covariance(2, 2));
  EXPECT_EQ(faultOf(next), "");
}

/// The increments of a drive, one of them in two parts of which the first is of a millisecond and
/// has more than its part of the covariance: what an odometry adds to each increment.
std::vector<Motion> driveWithAShortIncrement() {
  auto all = drive(20);
  auto [first, second] = split(all[2], all[2].start + std::chrono::milliseconds(1));
  first.covariance = 0.1 * all[2].covariance;
  all[2] = first;
  all.insert(all.begin() + 3, second);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].sequence = i;
  return all;
}

TEST(MotionGap, IsNotAsUncertainAsAShortIncrementSeemsToTell) {
  const auto covarianceAfter = [](const std::vector<Motion>& all) {
    MotionGap gap;
    for (std::size_t i = 0; i < 5; ++i) {
      auto motion = all[i];
      EXPECT_EQ(gap.bridge(motion), Bridge::kNone);
    }
    auto next = all.back();
    EXPECT_EQ(gap.bridge(next), Bridge::kByPoses);
    return next.covariance;
  };
  const auto covariance = covarianceAfter(driveWithAShortIncrement());
  EXPECT_LT(covariance.trace(), 1.5 * covarianceAfter(drive(20)).trace());
}

TEST(MotionGap, IsBridgedAtOnceByWhatAShortIncrementTells) {
  const auto all = driveWithAShortIncrement();
  MotionGap gap;
  auto first = all[2], next = all[12];
  gap.bridge(first);
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_EQ(faultOf(next), "");
}

TEST(MotionGap, OfWheelsThatAreCalibratedIsBridgedWithTheirScales) {
  auto all = drive(60);
  for (auto& motion : all) {
    Eigen::Vector3d twist = motion.increment.log();
    twist.head<2>() *= 1.05;
    twist.z() *= 0.9;
    motion.increment = Pose2::exp(twist);  // odometry's poses stay as they were measured
  }
  MotionGap gap;
  for (std::size_t i = 0; i < 5; ++i) gap.bridge(all[i]);
  Motion next = all[40], expected = all[5];
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  for (int i = 6; i <= 40; ++i) expected = joined(expected, all[i]);
  EXPECT_LT((next.increment.vector() - expected.increment.vector()).norm(), 1e-5);
}

TEST(MotionGap, IsNotSeenWhereAMotionComesLate) {
  const auto all = drive(10);
  MotionGap gap;
  for (int i : {0, 1, 2, 3, 1, 4, 3, 5}) {
    Motion next = all[i];
    EXPECT_EQ(gap.bridge(next), Bridge::kNone) << i;
  }
}

TEST(MotionGap, IsBridgedWhereTheSourceWasRestartedAndCountsAnew) {
  const auto all = drive(20);
  MotionGap gap;
  for (int i : {0, 1, 2}) {
    Motion next = all[i];
    gap.bridge(next);
  }
  Motion next = all[10], expected = all[3];
  next.sequence = 0;
  ASSERT_EQ(gap.bridge(next), Bridge::kByPoses);
  for (int i = 4; i <= 10; ++i) expected = joined(expected, all[i]);
  EXPECT_EQ(next.start, expected.start);
  EXPECT_EQ(next.sequence, 0u);
  EXPECT_LT((next.increment.vector() - expected.increment.vector()).norm(), 1e-9);
  EXPECT_TRUE(next.covariance.isApprox(expected.covariance, 1e-6)) << next.covariance;
  next = all[11];
  next.sequence = 1;
  EXPECT_EQ(gap.bridge(next), Bridge::kNone);
}

TEST(MotionGap, NeedsNoLossToBeBridged) {
  const auto all = drive(20);
  MotionGap gap;
  Motion next = all[3];
  gap.bridge(next);
  next = all[10];
  next.sequence = all[3].sequence + 1;
  EXPECT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_EQ(next.start, all[3].end);
}

/// A drive whose odometry has begun elsewhere than at its origin.
std::vector<Motion> driveFromElsewhere(int steps) {
  const Pose2 begin(20, -10, 1);
  auto all = drive(steps);
  for (auto& motion : all) {
    motion.odometry_start = begin * motion.odometry_start;
    motion.odometry_end = begin * motion.odometry_end;
  }
  return all;
}

/// It has seen all[0..3].
MotionGap gapAfterFour(const std::vector<Motion>& all) {
  MotionGap gap;
  for (int i : {0, 1, 2, 3}) {
    Motion motion = all[i];
    gap.bridge(motion);
  }
  return gap;
}

/// What is told of all[13] after all[0..3], with the odometry's poses changed.
template <class Change>
Motion bridgedByVelocity(const Change& change) {
  const auto all = driveFromElsewhere(20);
  auto gap = gapAfterFour(all);
  Motion next = all[13], expected = all[4];
  change(next);
  EXPECT_EQ(gap.bridge(next), Bridge::kByVelocity);
  for (int i = 5; i <= 13; ++i) expected = joined(expected, all[i]);
  EXPECT_EQ(next.start, all[3].end);
  EXPECT_EQ(faultOf(next), "");
  // the simulated robot does go on at one velocity; nobody knows that it does
  EXPECT_LT((next.increment.vector() - expected.increment.vector()).norm(), 0.1);
  EXPECT_GT(next.covariance(0, 0), 100.0 * expected.covariance(0, 0));
  EXPECT_GT(next.covariance(0, 0), std::pow(0.5 * expected.increment.position().norm(), 2));
  return next;
}

TEST(MotionGap, IsBridgedByTheLastVelocityWhereTheOdometryWasRestartedAsWell) {
  bridgedByVelocity([](Motion& next) {
    const Pose2 way = next.odometry_start.between(next.odometry_end);
    next.odometry_start = Pose2();
    next.odometry_end = way;
  });
}

TEST(MotionGap, IsBridgedByTheLastVelocityWhereThePosesAreImpossible) {
  bridgedByVelocity([](Motion& next) {
    const Pose2 far(1e6, 0, 0);
    next.odometry_start = far * next.odometry_start;
    next.odometry_end = far * next.odometry_end;
  });
}

TEST(MotionGap, IsBridgedByTheLastVelocityWhereAnotherOdometryGoesOn) {
  const auto next =
      bridgedByVelocity([](Motion& motion) { motion.odometry_frame = "visual_odom"; });
  EXPECT_EQ(next.odometry_frame, "visual_odom");
}

/// What becomes of all[next] in a process that was resumed after all[0..3].
struct Resumed {
  Bridge bridge;
  std::optional<bool> went_on;
  Motion motion;
};

template <class Change>
Resumed resumed(std::size_t next, const Change& change,
                Interruption interruption = Interruption::kOfThisProcess) {
  const auto all = driveFromElsewhere(700);
  auto gap = gapAfterFour(all);
  gap.resume(interruption);
  Resumed result{Bridge::kNone, std::nullopt, all[next]};
  change(result.motion);
  result.bridge = gap.bridge(result.motion);
  result.went_on = gap.wentOn();
  auto later = all[next + 1];
  gap.bridge(later);
  EXPECT_FALSE(gap.wentOn().has_value()) << "of the first motion only";
  return result;
}

/// The odometry's origin is now where it was at the start of the motion.
void restartOdometry(Motion& motion) {
  motion.odometry_end = motion.odometry_start.between(motion.odometry_end);
  motion.odometry_start = Pose2();
}

TEST(MotionGap, OfAResumedProcessIsBridgedByPosesWhereTheOdometryHasGoneOn) {
  const auto next = resumed(60, [](Motion&) {});
  EXPECT_EQ(next.bridge, Bridge::kByPoses);
  EXPECT_EQ(next.went_on, true);
}

/// Two metres off the way in half a second; with a driver that ran on it is what the robot did.
TEST(MotionGap, OfAResumedProcessIsNotBridgedByUnusualPosesWhereTheOdometryMayHaveStopped) {
  const auto shift = [](Motion& motion) {
    motion.odometry_start = Pose2(0, 2, 0) * motion.odometry_start;
    motion.odometry_end = Pose2(0, 2, 0) * motion.odometry_end;
  };
  EXPECT_EQ(resumed(6, shift).bridge, Bridge::kByPoses);
  const auto next = resumed(6, shift, Interruption::kOfAll);
  EXPECT_EQ(next.bridge, Bridge::kByVelocity);
  EXPECT_EQ(next.went_on, false);
}

TEST(MotionGap, OfAResumedProcessIsBridgedByTheVelocityWhereTheOdometryWasRestarted) {
  const auto next = resumed(60, restartOdometry);
  EXPECT_EQ(next.bridge, Bridge::kByVelocity);
  EXPECT_EQ(next.went_on, false);
  EXPECT_GT(next.motion.covariance(0, 0), 1.0);
}

/// Ten minutes at the last velocity would lead somewhere far from any truth.
TEST(MotionGap, OfAProcessThatIsResumedLaterIsNotBridged) {
  for (const auto pause : {std::chrono::hours(10), std::chrono::hours(-10)}) {
    const auto next = resumed(20, [&](Motion& motion) {
      motion.start += pause;
      motion.end += pause;
    });
    EXPECT_EQ(next.bridge, Bridge::kUnknown);
    EXPECT_EQ(next.went_on, false);
  }
  EXPECT_EQ(resumed(620, [](Motion&) {}).bridge, Bridge::kUnknown) << "a minute";
}

/// As of a source in the same process, which was resumed as well.
TEST(MotionGap, OfAResumedProcessMayBeInOneMotion) {
  const auto all = drive(10);
  const auto span = [](Motion& motion) {
    const auto first = drive(10)[4];
    const Pose2 begin(20, -10, 1);
    motion.start = first.start;
    motion.odometry_start = begin * first.odometry_start;
  };
  const auto next = resumed(8, span);
  EXPECT_EQ(next.bridge, Bridge::kNone);
  EXPECT_EQ(next.went_on, true);
  const auto jumped = resumed(8, [&](Motion& motion) {
    span(motion);
    motion.odometry_start = Pose2(0.2, 0, 0) * motion.odometry_start;
  });
  EXPECT_EQ(jumped.went_on, false);
}

TEST(MotionGap, OfAResetOdometryIsNone) {
  const auto all = drive(20);
  MotionGap gap;
  Motion next = all[0];
  gap.bridge(next);
  gap.reset();
  next = all[19];
  EXPECT_EQ(gap.bridge(next), Bridge::kNone) << "the first after a reset";
}

TEST(MotionGap, IsBridgedFromBeforeStampsThatJumpedAndCameBack) {
  const auto all = drive(20);
  MotionGap gap;
  for (int i : {0, 1, 2, 3}) {
    Motion motion = all[i];
    gap.bridge(motion);
  }
  for (int i : {4, 5}) {
    Motion motion = all[i];
    motion.end += std::chrono::seconds(100);
    if (i == 5) motion.start += std::chrono::seconds(100);
    EXPECT_EQ(gap.bridge(motion), Bridge::kNone);
  }
  Motion next = all[7];
  EXPECT_EQ(gap.bridge(next), Bridge::kByPoses);
  EXPECT_EQ(next.start, all[3].end);
  next = all[8];
  EXPECT_EQ(gap.bridge(next), Bridge::kNone);
}

}  // namespace
}  // namespace slam
