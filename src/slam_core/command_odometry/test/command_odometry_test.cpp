// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/command_odometry/command_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"

namespace slam::command_odometry {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

void expectNear(const Pose2& a, const Pose2& b, double tolerance = 1e-12) {
  EXPECT_LT((a.vector() - b.vector()).norm(), tolerance)
      << a.vector().transpose() << " and " << b.vector().transpose();
}

class CommandOdometryTest : public testing::Test {
 protected:
  void SetUp() override {
    config.time_constant = 0.0;
    odometry.configure(config);
  }
  /// Gives a command and takes all pieces of the way up to it.
  Status take(double stamp, const Eigen::Vector3d& twist) {
    pieces.clear();
    odometry.set({at(stamp), twist});
    const auto status = odometry.execute();
    while (odometry.motion()) {
      pieces.push_back(*odometry.motion());
      EXPECT_EQ(faultOf(pieces.back()), "");
      if (pieces.size() > 1) {
        EXPECT_EQ(pieces.back().start, pieces[pieces.size() - 2].end);
        EXPECT_EQ(pieces.back().sequence, pieces[pieces.size() - 2].sequence + 1);
      }
      if (!odometry.isBusy()) break;
      EXPECT_TRUE(odometry.execute().isOk());
    }
    return status;
  }
  Pose2 moved() const {
    Pose2 sum;
    for (const auto& piece : pieces) sum = sum * piece.increment;
    return sum;
  }
  std::uint64_t counted(const std::string& name) const { return odometry.counters()[name]; }

  CommandOdometryConfig config;
  CommandOdometry odometry;
  std::vector<Motion> pieces;
};

TEST_F(CommandOdometryTest, HoldsACommandUntilTheNextOne) {
  EXPECT_TRUE(take(5, {1, 0, 0.5}).isOk());
  EXPECT_TRUE(pieces.empty()) << "one command is no motion";
  EXPECT_TRUE(take(5.2, {0, 0, 0}).isOk());
  expectNear(moved(), Pose2::exp({0.2, 0, 0.1}));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].start, at(5));
  EXPECT_EQ(pieces[0].end, at(5.2));
  EXPECT_EQ(pieces[0].sequence, 0u);
  take(5.4, {7, 0, 0});
  expectNear(moved(), Pose2());
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].sequence, 1u);
  expectNear(pieces[0].odometry_end, Pose2::exp({0.2, 0, 0.1}));
}

TEST_F(CommandOdometryTest, TakesTheBaseToStopAfterItsTimeout) {
  config.time_constant = 0.1;
  odometry.configure(config);
  take(0, {1, 0, 0});
  take(0.4, {1, 0, 0});
  take(3.4, {1, 0, 0});
  EXPECT_NEAR(moved().x(), config.timeout + 0.1, 0.01) << "and it rolls on";
  EXPECT_EQ(pieces.back().increment.vector(), Eigen::Vector3d(0, 0, 0)) << "it stands";
  EXPECT_EQ(pieces.back().start, at(0.4 + config.timeout + 0.5));
  EXPECT_NEAR(pieces[0].increment.x(), 0.2, 0.005) << "of the first 0.2 s";
}

TEST_F(CommandOdometryTest, TurnsOnWhereOneCommandHoldsForMoreThanHalfATurn) {
  config.timeout = 5.0;
  odometry.configure(config);
  take(0, {0.5, 0, 2.0});
  take(4, {0, 0, 0});
  double turned = 0.0;
  for (const auto& piece : pieces) turned += piece.increment.theta();
  EXPECT_NEAR(turned, 8.0, 1e-9);
}

TEST_F(CommandOdometryTest, IsAsUncertainHoweverOftenACommandIsRepeated) {
  const auto variance = [&](double interval) {
    odometry.configure(config);
    take(0, {1, 0, 0});
    double sum = 0.0;
    for (int i = 1; i <= std::lround(1.0 / interval); ++i) {
      take(i * interval, {1, 0, 0});
      for (const auto& piece : pieces) sum += piece.covariance(0, 0);
    }
    return sum;
  };
  EXPECT_NEAR(variance(0.01), variance(0.05), 1e-4 * variance(0.05));
  EXPECT_GT(variance(0.4), 6.0 * variance(0.05)) << "an error lasts as long as its command";
}

TEST_F(CommandOdometryTest, BeginsAnewWhereTheRobotMayHaveMovedMeanwhile) {
  take(0, {1, 0, 0});
  odometry.goOnLive();
  take(3, {1, 0, 0});
  EXPECT_TRUE(pieces.empty());
}

TEST_F(CommandOdometryTest, FollowsWithALag) {
  config.time_constant = 0.2;
  odometry.configure(config);
  take(0, {1, 0, 0});
  double way = 0.0;
  for (int i = 1; i <= 40; ++i) {
    take(0.05 * i, {1, 0, 0});
    way += moved().x();
  }
  // a numerical integral of dv/dt = (1 - v) / 0.2
  double velocity = 0.0, expected = 0.0;
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200000; ++i) {
    velocity += kStep * (1.0 - velocity) / 0.2;
    expected += kStep * velocity;
  }
  EXPECT_NEAR(way, expected, 1e-4);
  take(2.05, {0, 0, 0});
  take(2.55, {0, 0, 0});
  EXPECT_NEAR(moved().x(), 0.2 * (1.0 - std::exp(-2.5)), 1e-4) << "it rolls on";
}

TEST_F(CommandOdometryTest, SaysHowUncertainARobotIsThatErrsAsTheVelocityModelHasIt) {
  config.noise = {0.04, 0.01, 0.02, 0.09, false, 0.01, 0.02};
  odometry.configure(config);
  const Eigen::Vector3d commanded(0.8, 0.0, 0.6);
  constexpr double kInterval = 0.2;
  take(0, commanded);
  take(kInterval, commanded);
  RandomStream random(1, 1);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  constexpr int kRuns = 20000;
  for (int i = 0; i < kRuns; ++i) {  // table 5.3
    const double v2 = commanded.x() * commanded.x(), w2 = commanded.z() * commanded.z();
    const Eigen::Vector3d driven(
        commanded.x() + std::sqrt(0.04 * v2 + 0.01 * w2) * random.gaussian(), 0,
        commanded.z() + std::sqrt(0.02 * v2 + 0.09 * w2) * random.gaussian());
    const double last = std::sqrt(0.01 * v2 + 0.02 * w2) * random.gaussian();
    const Pose2 pose = Pose2::exp(kInterval * driven) * Pose2(0, 0, kInterval * last);
    const Eigen::Vector3d error = pose.vector() - moved().vector();
    scatter += error * error.transpose() / kRuns;
  }
  scatter.diagonal() += kInterval * Eigen::Vector3d(config.floor_position * config.floor_position,
                                                    config.floor_position * config.floor_position,
                                                    config.floor_heading * config.floor_heading);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_LT((pieces[0].covariance - scatter).norm(), 0.05 * scatter.norm())
      << pieces[0].covariance << "\n\n"
      << scatter;
}

TEST_F(CommandOdometryTest, SaysThatADriverSetsNoStamps) {
  take(0, {1, 0, 0});
  EXPECT_EQ(take(0, {1, 0, 0}).message,
            "a command has the stamp 0, since its driver sets none; it is left out");
}

TEST_F(CommandOdometryTest, LeavesOutWhatIsLateOrNoNumber) {
  take(1, {1, 0, 0});
  EXPECT_EQ(take(1, {2, 0, 0}).message,
            "a command is not newer than the one before it; it is left out");
  EXPECT_EQ(take(1.05, {kNoNumber, 0, 0}).message,
            "a command holds a value that is not a number; it is left out");
  EXPECT_TRUE(take(1.1, {1, 0, 0}).isOk());
  expectNear(moved(), Pose2(0.1, 0, 0));
  EXPECT_EQ(counted("late"), 1u);
  EXPECT_EQ(counted("invalid"), 1u);
  EXPECT_EQ(odometry.dropped(), 2u);
}

TEST_F(CommandOdometryTest, TakesTheRobotToDoNoMoreThanItCan) {
  config.max_speed = 0.5;
  config.max_turn_rate = 1.0;
  odometry.configure(config);
  EXPECT_NE(take(0, {3, 4, -2}).message.find("command_odometry.max_speed"), std::string::npos);
  take(0.1, {0, 0, 0});
  expectNear(moved(), Pose2::exp({0.03, 0.04, -0.1}));
  EXPECT_EQ(counted("limited"), 1u);
  EXPECT_EQ(odometry.dropped(), 0u);
}

TEST_F(CommandOdometryTest, LosesNothingOfAPause) {
  take(0, {1, 0, 0});
  take(0.1, {1, 0, 0});
  EXPECT_TRUE(take(30, {2, 0, 0}).isOk());
  EXPECT_TRUE(pieces.empty()) << "the stamp may be wrong";
  EXPECT_TRUE(take(30.1, {2, 0, 0}).isOk());
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().start, at(0.1));
  EXPECT_EQ(pieces.front().sequence, 1u);
  EXPECT_EQ(pieces.back().end, at(30.1));
  expectNear(moved(), Pose2(config.timeout * 1.0 + 0.1 * 2.0, 0, 0));
  EXPECT_EQ(odometry.dropped(), 0u);
}

TEST_F(CommandOdometryTest, LeavesOutACommandWhoseStampAloneJumpsAhead) {
  take(0, {1, 0, 0});
  take(30, {9, 0, 0});
  EXPECT_NE(take(0.2, {1, 0, 0}).message.find("stamped far ahead"), std::string::npos);
  expectNear(moved(), Pose2(0.2, 0, 0));
  EXPECT_EQ(counted("stamp_jump"), 1u);
}

TEST_F(CommandOdometryTest, AWrongStampDoesNotConfirmOneBehindAPause) {
  take(0, {1, 0, 0});
  take(30, {1, 0, 0});
  EXPECT_FALSE(take(1e6, {9, 0, 0}).isOk());
  EXPECT_TRUE(pieces.empty());
  EXPECT_EQ(counted("stamp_jump"), 1u);
  take(30.1, {1, 0, 0});
  EXPECT_EQ(counted("stamp_jump"), 2u);
  take(30.2, {1, 0, 0});
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.back().end, at(30.2));
}

TEST_F(CommandOdometryTest, BeginsAnewWhereStampsStartOver) {
  take(100, {1, 0, 0});
  take(100.1, {1, 0, 0});
  EXPECT_TRUE(take(3, {1, 0, 0}).isOk());
  EXPECT_TRUE(pieces.empty());
  take(3.1, {1, 0, 0});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].start, at(3));
}

TEST(CommandOdometryConfig, RefusesWhatCannotBe) {
  CommandOdometryConfig config;
  config.timeout = 0.0;
  config.noise.alpha1 = -1.0;
  const auto faults = test::faultsOf([&] { CommandOdometry().configure(config); });
  EXPECT_TRUE(test::oneSays(faults, {"timeout"}));
  EXPECT_TRUE(test::oneSays(faults, {"alpha1"}));
}

}  // namespace
}  // namespace slam::command_odometry
