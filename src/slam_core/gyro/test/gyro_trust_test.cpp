// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_trust.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::gyro {
namespace {

using Verdict = GyroTrust::Verdict;

constexpr double kInterval = 0.05;  // [s]

Motion wheelsThat(double turn_rate, double speed = 0.3) {
  Motion motion;
  motion.end = motion.start + durationFromSeconds(kInterval);
  motion.increment = Pose2::exp(kInterval * Eigen::Vector3d(speed, 0.0, turn_rate));
  motion.covariance = 1e-5 * Eigen::Matrix3d::Identity();
  return motion;
}

class GyroTrustTest : public testing::Test {
 protected:
  /// @param ratio of the gyro's turn and the wheels'
  void turn(double seconds, double ratio, double turn_rate = 0.5) {
    for (int i = 0; i < std::lround(seconds / kInterval); ++i)
      trust.add(ratio * kInterval * turn_rate, wheelsThat(turn_rate), 0.01);
  }
  bool believes(double ratio, double turn_rate = 0.5) const {
    return trust.believes(ratio * kInterval * turn_rate, wheelsThat(turn_rate), 0.01);
  }

  GyroTrust trust;
};

TEST_F(GyroTrustTest, IsProvenByTurnsEvenIfWheelsAreWrongByAFactorOfTwo) {
  for (const double ratio : {1.0, 0.5, 2.0}) {
    trust.reset();
    EXPECT_EQ(trust.verdict(), Verdict::kUnproven);
    turn(3.0, ratio);
    EXPECT_EQ(trust.verdict(), Verdict::kProven) << ratio;
  }
}

TEST_F(GyroTrustTest, IsProvenAlsoWhereTheRobotFileCallsTheWheelsBad) {
  auto wheels = wheelsThat(0.5);
  wheels.covariance(2, 2) = 0.12 * 0.5 * kInterval;
  for (int i = 0; i < 100; ++i) trust.add(0.35 * kInterval, wheels, 0.01);
  EXPECT_EQ(trust.verdict(), Verdict::kProven);
}

TEST_F(GyroTrustTest, NamesWhatIsWrong) {
  const std::pair<double, Verdict> cases[] = {{57.3, Verdict::kTooLarge},
                                              {-57.3, Verdict::kTooLarge},
                                              {-1.0, Verdict::kOpposite},
                                              {0.01, Verdict::kUnrelated}};
  for (const auto& [ratio, verdict] : cases) {
    trust.reset();
    turn(4.0, ratio);
    EXPECT_EQ(trust.verdict(), verdict) << ratio;
    EXPECT_FALSE(believes(1.0)) << "until turns have shown it";
    turn(4.0, 1.0);
    EXPECT_EQ(trust.verdict(), Verdict::kProven) << ratio;
  }
}

TEST_F(GyroTrustTest, BelievesNothingStrangeBeforeItIsProven) {
  EXPECT_TRUE(believes(1.0));
  EXPECT_TRUE(believes(0.6));
  EXPECT_FALSE(believes(57.3));
  EXPECT_FALSE(believes(-1.0, 1.5));
  EXPECT_TRUE(believes(-1.0, 0.02)) << "noise";
}

TEST_F(GyroTrustTest, BelievesAProvenGyroWhereWheelsSpin) {
  turn(3.0, 1.0);
  turn(5.0, 0.0);
  EXPECT_TRUE(believes(0.0));
  EXPECT_EQ(trust.verdict(), Verdict::kProven);
}

TEST(GyroTrust, ABurstIsASpinThatTheWheelsDoNotConfirm) {
  EXPECT_TRUE(GyroTrust::isBurst(30.0, wheelsThat(0.5)));
  EXPECT_TRUE(GyroTrust::isBurst(-30.0, wheelsThat(0.5)));
  EXPECT_FALSE(GyroTrust::isBurst(6.0, wheelsThat(0.5))) << "somebody may turn the robot by hand";
  EXPECT_FALSE(GyroTrust::isBurst(14.0, wheelsThat(12.0)));
}

TEST_F(GyroTrustTest, IsNotRefutedByUnequalWheelsOnAStraightWay) {
  for (int i = 0; i < 2000; ++i) trust.add(0.0, wheelsThat(0.1, 1.0), 0.01);
  EXPECT_EQ(trust.verdict(), Verdict::kUnproven);
}

TEST_F(GyroTrustTest, IsRefutedAfterwardsTooWhereTurnAfterTurnIsOpposite) {
  turn(20.0, 1.0);
  turn(5.0, -1.0);
  EXPECT_EQ(trust.verdict(), Verdict::kOpposite);
}

}  // namespace
}  // namespace slam::gyro
