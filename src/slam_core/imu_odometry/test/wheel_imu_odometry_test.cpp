// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu_odometry/wheel_imu_odometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <string>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/imu_odometry/test/driven_odometry.hpp"

namespace slam::imu_odometry {
namespace {

using test::DrivenOdometry;
using test::headingError;
using test::TurningRobot;

constexpr test::WheelErrors kPoorWheels = {0.4, 0.03, {1e-4, 2e-5, 1e-3, 2e-3}};
constexpr test::GyroErrors kMems = {0.008, 2e-5, 2e-4, 0.0};

TurningRobot poorRobot(std::uint64_t seed = 1, TurningRobot::Rates rates = {}) {
  TurningRobot robot(seed, kPoorWheels, kMems, rates);
  robot.drive(test::someDrive());
  return robot;
}

void expectSameBytes(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].start, b[i].start);
    EXPECT_EQ(a[i].increment.vector(), b[i].increment.vector()) << i;
    EXPECT_EQ(a[i].covariance, b[i].covariance) << i;
  }
}

TEST(WheelImuOdometry, KnowsTheHeadingThatWheelsMeasureWrongly) {
  const auto robot = poorRobot();
  DrivenOdometry driven;
  driven.take(robot);
  EXPECT_NEAR(headingError(driven, robot), 0.0, 0.03);
  const auto last = driven.motions.size();
  EXPECT_LT((driven.pose().position() - robot.truth()[last].pose.position()).norm(), 0.3);
  EXPECT_GT((robot.wheels()[last].pose->position() - robot.truth()[last].pose.position()).norm(),
            1.0);
  EXPECT_EQ(driven.messages, std::vector<std::string>());
}

TEST(WheelImuOdometry, MakesOneMotionOfEachOfTheWheels) {
  const auto robot = poorRobot();
  DrivenOdometry driven;
  driven.take(robot);
  ASSERT_GE(driven.motions.size() + 2, robot.wheels().size());
  for (std::size_t i = 0; i < driven.motions.size(); ++i) {
    const auto& motion = driven.motions[i];
    EXPECT_EQ(motion.sequence, i);
    EXPECT_EQ(motion.start, robot.wheels()[i].stamp);
    EXPECT_EQ(motion.end, robot.wheels()[i + 1].stamp);
    EXPECT_EQ(motion.odometry_end.vector(), robot.wheels()[i + 1].pose->vector())
        << "it moves along the driver's frame";
    EXPECT_EQ(motion.odometry_frame, "odom");
    EXPECT_EQ(faultOf(motion), "") << i;
  }
}

TEST(WheelImuOdometry, FindsBiasAndNoiseWhileTheRobotRests) {
  TurningRobot robot(1, kPoorWheels, {0.02, 0.0, 1e-3, 0.0});
  robot.drive({{30.0, 0.0, 0.0}});
  DrivenOdometry driven;
  driven.take(robot);
  const auto figures = driven.odometry.figures();
  EXPECT_EQ(figures[0].first, "gyro_bias");
  EXPECT_NEAR(figures[0].second, 0.02, 5e-4);
  EXPECT_EQ(figures[1].first, "gyro_bias_sigma");
  EXPECT_NEAR(figures[1].second, 1e-3 / std::sqrt(30.0), 1e-4);
  EXPECT_EQ(figures[2].first, "gyro_noise");
  EXPECT_NEAR(figures[2].second, 1e-3, 2e-4);
  EXPECT_NEAR(driven.pose().theta(), 0.0, 1e-9) << "the heading does not drift meanwhile";
}

/// As arrays that come by two topics: each in its own order, the gyro's first, last, or in bursts.
TEST(WheelImuOdometry, DoesNotDependOnTheOrderOfArrival) {
  const auto robot = poorRobot(2, {20, 50});
  DrivenOdometry live;
  live.take(robot);
  for (const auto lag : {std::chrono::milliseconds(-800), std::chrono::milliseconds(-70),
                         std::chrono::milliseconds(70), std::chrono::milliseconds(800)}) {
    auto gyro = robot.gyro();
    DrivenOdometry other;
    auto sample = gyro.begin();
    for (const auto& of_wheels : robot.wheels()) {
      for (; sample != gyro.end() && sample->stamp + lag <= of_wheels.stamp; ++sample)
        other.take(*sample);
      other.take(of_wheels);
    }
    for (; sample != gyro.end(); ++sample) other.take(*sample);
    expectSameBytes(live.motions, other.motions);
    EXPECT_EQ(live.odometry.counters().all(), other.odometry.counters().all());
  }
}

TEST(WheelImuOdometry, ResetIsAFreshStart) {
  const auto robot = poorRobot();
  DrivenOdometry driven;
  driven.take(robot);
  const auto first = driven.motions;
  driven.odometry.reset();
  driven.motions.clear();
  driven.take(robot);
  expectSameBytes(first, driven.motions);
}

TEST(WheelImuOdometry, GoesOnFromASavedStateAsIfNeverStopped) {
  const auto robot = poorRobot();
  DrivenOdometry whole;
  whole.take(robot);
  for (const std::size_t cut : {3, 40, 333, 1000}) {
    const std::size_t gyro_cut = cut * 5 / 2;
    const std::vector<OdometrySample> wheels(robot.wheels().begin(), robot.wheels().begin() + cut);
    const std::vector<ImuSample> gyro(robot.gyro().begin(), robot.gyro().begin() + gyro_cut);
    DrivenOdometry before, after;
    before.take(wheels, gyro);
    ArchiveWriter writer;
    before.odometry.saveState(writer);
    const auto state = writer.take();
    ArchiveReader reader(state);
    after.odometry.restoreState(reader);
    after.motions = before.motions;
    after.take({robot.wheels().begin() + cut, robot.wheels().end()},
               {robot.gyro().begin() + gyro_cut, robot.gyro().end()});
    expectSameBytes(whole.motions, after.motions);
    EXPECT_EQ(whole.odometry.counters().all(), after.odometry.counters().all());
  }
}

/// Who gives the noise of each sample is believed where it is more than was measured.
TEST(WheelImuOdometry, TakesTheDriversCovarianceWhereItIsLarger) {
  const auto robot = poorRobot();
  const auto variance_with = [&](double rate_variance) {
    auto gyro = robot.gyro();
    for (auto& sample : gyro) sample.covariance(2, 2) = rate_variance;
    DrivenOdometry driven;
    driven.take(robot.wheels(), gyro);
    return driven.motions[1200].covariance(2, 2);
  };
  const double measured = variance_with(0.0);
  EXPECT_EQ(variance_with(1e-9), measured);
  constexpr double kRateVariance = 0.04;  // at 100 Hz a density of 0.02
  EXPECT_NEAR(variance_with(kRateVariance) - measured, kRateVariance * 0.01 * 0.025, 2e-6);
}

TEST(WheelImuOdometry, IsCertainOfNothingBeforeItHasRested) {
  TurningRobot robot(3, kPoorWheels, kMems);
  robot.drive({{60.0, 0.5, 0.05}});
  DrivenOdometry driven;
  driven.take(robot);
  const double sigma = driven.odometry.figures()[1].second;
  EXPECT_GT(sigma, 0.003) << "the prior is 0.01";
  EXPECT_LT(std::abs(driven.odometry.figures()[0].second - robot.bias()), 3.0 * sigma);
}

TEST(WheelImuOdometry, FollowsARobotThatSomebodyTurnsByHand) {
  const auto robot = poorRobot();
  auto wheels = robot.wheels();
  auto gyro = robot.gyro();
  DrivenOdometry driven;
  driven.take(wheels, gyro);
  const double before = driven.pose().theta();
  auto last = gyro.back();
  for (int i = 1; i <= 800; ++i) {  // 8 s; turned from the fourth to the sixth, by 1 rad
    last.stamp += std::chrono::milliseconds(10);
    const double swing =
        i >= 300 && i < 500 ? 0.5 * M_PI / 2.0 * std::sin(M_PI * (i - 300) / 200.0) : 0.0;
    last.angular_velocity.z() = robot.bias() + swing + 1e-6 * i;
    driven.take(last);
    if (i % 4 != 0) continue;
    wheels.back().stamp = last.stamp;
    driven.take(wheels.back());
  }
  EXPECT_NEAR(driven.pose().theta() - before, 1.0, 0.05);
  EXPECT_EQ(driven.messages, std::vector<std::string>());
}

TEST(WheelImuOdometry, NamesAllFaultsOfItsSections) {
  auto settings = test::robotSettings(
      "{version: 1, wheel_odometry: {alpha1: -1}, imu: {gyro_noise: 0, bias_sgma: 1}}");
  WheelImuOdometry odometry;
  const auto faults = slam::test::faultsOf([&] { odometry.configure(settings); });
  EXPECT_TRUE(slam::test::oneSays(faults, {"wheel_odometry.alpha1"}));
  EXPECT_TRUE(slam::test::oneSays(faults, {"imu.gyro_noise"}));
  EXPECT_TRUE(slam::test::oneSays(faults, {"bias_sgma", "bias_sigma"}));
}

}  // namespace
}  // namespace slam::imu_odometry
