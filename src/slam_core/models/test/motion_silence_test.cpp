// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "slam_core/models/motion_gap.hpp"
#include "slam_core/models/test/simulated_world.hpp"

// An odometry that was silent may report the motion since then as if it were one arc.

namespace slam {
namespace {

using Bridge = MotionGap::Bridge;

/// Most of a lap in a circle.
constexpr int kSilence = 9 * test::SimulatedWorld::kLap / 10;

/// A robot that drives in a circle, and its odometry.
class SilentOdometry : public testing::Test {
 protected:
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      auto motion = world_.next().motion;
      EXPECT_EQ(gap_.bridge(motion), Bridge::kNone);
      EXPECT_FALSE(gap_.unknownWay());
    }
  }
  /// @return the motion that is reported after a silence of so many steps
  Motion silent(int steps) {
    auto motion = world_.next().motion;
    for (int i = 1; i < steps; ++i) motion = joined(motion, world_.next().motion);
    EXPECT_EQ(gap_.bridge(motion), Bridge::kNone);
    return motion;
  }
  /// @return the motion after as many steps whose motions were lost
  Motion lost(int steps) {
    for (int i = 1; i < steps; ++i) world_.next();
    auto motion = world_.next().motion;
    EXPECT_EQ(gap_.bridge(motion), Bridge::kByPoses);
    return motion;
  }

  test::SimulatedWorld world_{1};
  MotionGap gap_;
};

TEST_F(SilentOdometry, IsAsUncertainAsAGap) {
  drive(5);
  auto other = gap_;
  auto world = world_;
  const auto after_silence = silent(kSilence);
  ASSERT_TRUE(gap_.unknownWay());
  EXPECT_EQ(gap_.unknownWay()->first, after_silence.start);
  EXPECT_EQ(gap_.unknownWay()->second, after_silence.end);
  std::swap(gap_, other);
  std::swap(world_, world);
  const auto after_loss = lost(kSilence);
  EXPECT_LT((after_silence.increment.vector() - after_loss.increment.vector()).norm(), 1e-9);
  EXPECT_TRUE(after_silence.covariance.isApprox(after_loss.covariance, 0.1))
      << after_silence.covariance << "\n\n"
      << after_loss.covariance;
}

TEST_F(SilentOdometry, IsSoTheSecondTimeAsWell) {
  drive(5);
  silent(kSilence);
  silent(kSilence);
  EXPECT_TRUE(gap_.unknownWay());
  drive(5);
}

TEST_F(SilentOdometry, DoesNotSpoilWhatIsKnownOfItsNoise) {
  drive(5);
  auto other = gap_;
  auto doubtful = world_.next().motion;
  for (int i = 1; i < kSilence; ++i) doubtful = joined(doubtful, world_.next().motion);
  doubtful.covariance = Eigen::Matrix3d::Identity();  // as of a twist that was held
  EXPECT_EQ(gap_.bridge(doubtful), Bridge::kNone);
  drive(5);
  const auto after = lost(5);
  gap_ = other;
  world_ = test::SimulatedWorld(1);
  for (int i = 0; i < 5; ++i) world_.next();
  drive(kSilence + 5);
  const auto without = lost(5);
  EXPECT_TRUE(after.covariance.isApprox(without.covariance, 0.1)) << after.covariance;
}

TEST_F(SilentOdometry, IsNotMeantByOneThatIsAlwaysSlow) {
  auto motion = world_.next().motion;
  motion.end = motion.start + std::chrono::seconds(2);
  for (int i = 0; i < 5; ++i) {
    const auto covariance = motion.covariance;
    EXPECT_EQ(gap_.bridge(motion), Bridge::kNone);
    EXPECT_EQ(motion.covariance, covariance);
    EXPECT_FALSE(gap_.unknownWay());
    motion.odometry_start =
        std::exchange(motion.odometry_end, motion.odometry_end * motion.increment);
    motion.start = std::exchange(motion.end, motion.end + std::chrono::seconds(2));
  }
}

/// A driver that is held up from time to time reports ten motions then, stamped one after the
/// other.
TEST_F(SilentOdometry, IsNoMoreUncertainForBurstsBeforeIt) {
  constexpr Duration kUsual = std::chrono::milliseconds(100), kBurst = std::chrono::microseconds(1);
  const auto afterSilence = [&](bool has_bursts) {
    MotionGap gap;
    Motion motion;
    motion.end = Stamp() + std::chrono::seconds(1);
    motion.increment = Pose2(0.05, 0.0, 0.0);
    motion.covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
    const auto report = [&](Duration interval) {
      motion.start = motion.end;
      motion.end = motion.start + interval;
      motion.odometry_start = motion.odometry_end;
      motion.odometry_end = motion.odometry_start * motion.increment;
      auto bridged = motion;
      gap.bridge(bridged);
      return bridged;
    };
    for (int i = 0; i < 200; ++i) {
      const bool is_held_up = has_bursts && i % 20 == 10;
      report(is_held_up ? 10 * kUsual : kUsual);
      for (int j = 1; is_held_up && j < 10; ++j) report(kBurst);
    }
    return report(20 * kUsual).covariance;
  };
  const auto usual = afterSilence(false), after_bursts = afterSilence(true);
  EXPECT_LT(after_bursts(0, 0), 2.0 * usual(0, 0));
  EXPECT_LT(after_bursts(2, 2), 2.0 * usual(2, 2));
}

/// An odometry that reports after each metre, or turns and short steps as well, each after a
/// second.
class MotionByWay : public testing::Test {
 protected:
  static constexpr Duration kSecond = std::chrono::seconds(1), kPause = std::chrono::seconds(15);
  static constexpr double kVariance = 1e-3;  // of a step [m^2]

  MotionByWay() {
    motion_.end = Stamp() + kSecond;
    motion_.covariance = Eigen::Vector3d(kVariance, kVariance, 1e-4).asDiagonal();
  }
  void go(double step, Duration interval) {
    motion_.increment = Pose2(step, 0.0, 0.1);
    motion_.start = motion_.end;
    motion_.end = motion_.start + interval;
    motion_.odometry_start = motion_.odometry_end;
    motion_.odometry_end = motion_.odometry_start * motion_.increment;
  }
  /// @return the motion, bridged
  Motion report(double step, Duration interval = kSecond) {
    go(step, interval);
    auto bridged = motion_;
    bridge = gap.bridge(bridged);
    return bridged;
  }
  void drive(const std::vector<double>& steps = {1.0}) {
    for (std::size_t i = 0; i < 40; ++i) report(steps[i % steps.size()]);
  }

  MotionGap gap;
  Bridge bridge = Bridge::kNone;

 private:
  Motion motion_;
};

TEST_F(MotionByWay, HasTheNoiseOfAStepAfterAPauseInWhichTheRobotStood) {
  drive();
  EXPECT_DOUBLE_EQ(report(1.2, kPause).covariance(0, 0), kVariance);
  EXPECT_TRUE(gap.unknownWay()) << "nobody knows when it went on";
  report(1.0);
  EXPECT_FALSE(gap.unknownWay());
}

TEST_F(MotionByWay, IsAsUncertainAsAGapAfterALongerStep) {
  drive();
  EXPECT_GT(report(4.0, kPause).covariance(0, 0), 10.0 * kVariance);
}

TEST_F(MotionByWay, IsNotThatOfAnOdometryThatAlsoReportsStanding) {
  drive({1.0, 0.01, 0.01, 0.01});
  EXPECT_GT(report(1.0, kPause).covariance(0, 0), 10.0 * kVariance);
}

TEST_F(MotionByWay, HasTheNoiseOfItsStepsWhereAMessageWasLostBesideThePause) {
  drive();
  go(0.9, kPause);
  const auto bridged = report(1.0);
  EXPECT_EQ(bridge, Bridge::kByPoses);
  EXPECT_LT(bridged.covariance(0, 0), 4.0 * kVariance);
}

}  // namespace
}  // namespace slam
