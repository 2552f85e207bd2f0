// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slam_core/imu_odometry/test/driven_odometry.hpp"

// What goes wrong with an IMU: the wheels take over, it is said, and nothing is lost.

namespace slam::imu_odometry {
namespace {

using test::DrivenOdometry;
using test::headingError;
using test::TurningRobot;

/// Its wheels are right, so that a heading of theirs is a good one.
class WheelImuTrouble : public testing::Test {
 protected:
  WheelImuTrouble() : robot(1, {0.0, 0.0, {}}, {0.005, 0.0, 2e-4, 0.0}), gyro(rested()) {}

  std::vector<ImuSample> rested() {
    auto legs = test::someDrive();
    legs.insert(legs.end(), {{3, 0.4, 0.6}, {3, 0.4, -0.6}, {3, 0.0, 0.8}, {3, 0.4, 0.0}});
    robot.drive(legs);
    return robot.gyro();
  }
  double secondOf(const ImuSample& sample) const {
    return seconds(sample.stamp - robot.gyro().front().stamp);
  }
  template <class Change>
  void change(double begin, double end, Change change) {
    for (auto& sample : gyro)
      if (secondOf(sample) >= begin && secondOf(sample) < end) change(sample);
  }
  void leaveOut(double begin, double end) {
    gyro.erase(std::remove_if(gyro.begin(), gyro.end(),
                              [&](const auto& sample) {
                                return secondOf(sample) >= begin && secondOf(sample) < end;
                              }),
               gyro.end());
  }
  /// The heading stays right, each motion is there and can be used.
  void expectRightHeading(double tolerance = 0.05) {
    driven.take(robot.wheels(), gyro);
    EXPECT_NEAR(headingError(driven, robot), 0.0, tolerance);
    for (const auto& motion : driven.motions) EXPECT_EQ(faultOf(motion), "");
    for (std::size_t i = 1; i < driven.motions.size(); ++i)
      EXPECT_EQ(driven.motions[i].start, driven.motions[i - 1].end);
    // without the gyro the last second waits for it
    EXPECT_GE(driven.motions.size() + 42, robot.wheels().size());
  }
  std::uint64_t counted(const std::string& reason) const {
    return driven.odometry.counters()[reason];
  }

  TurningRobot robot;
  std::vector<ImuSample> gyro;
  DrivenOdometry driven;
};

TEST_F(WheelImuTrouble, NoneLeavesNothingToSay) {
  expectRightHeading(0.02);
  EXPECT_TRUE(driven.messages.empty());
  EXPECT_EQ(counted("gyro_implausible") + counted("gyro_stuck"), 0u);
}

TEST_F(WheelImuTrouble, AGyroThatCountsInDegreesIsNotBelieved) {
  change(0, 1e9, [](auto& sample) { sample.angular_velocity *= 180.0 / M_PI; });
  expectRightHeading(0.15);
  ASSERT_EQ(driven.messages.size(), 1u) << "it is said once";
  EXPECT_TRUE(
      driven.said("counts in degrees; set imu.units in the robot file; the wheels' heading"))
      << driven.messages[0];
  EXPECT_GT(counted("gyro_implausible"), 500u);
}

TEST_F(WheelImuTrouble, AGyroThatHangsUpsideDownUnknownToItsMountIsNotBelieved) {
  change(0, 1e9, [](auto& sample) { sample.angular_velocity *= -1.0; });
  expectRightHeading(0.25);
  ASSERT_EQ(driven.messages.size(), 1u);
  EXPECT_TRUE(driven.said("mounted upside down; correct its transform")) << driven.messages[0];
  EXPECT_GT(counted("gyro_implausible"), 500u);
}

TEST_F(WheelImuTrouble, AGyroThatMeasuresAboutAnotherAxisIsNotBelieved) {
  RandomStream random(1, 1);
  change(0, 1e9, [&](auto& sample) { sample.angular_velocity.z() = 0.002 * random.gaussian(); });
  expectRightHeading(1.5);  // of 3.3: what was lost before turns had shown it
  ASSERT_EQ(driven.messages.size(), 1u);
  EXPECT_TRUE(driven.said("does not measure the turns")) << driven.messages[0];
}

TEST_F(WheelImuTrouble, WheelsTakeOverInAGap) {
  leaveOut(12.0, 22.0);
  expectRightHeading();
  ASSERT_EQ(driven.messages.size(), 1u);
  EXPECT_TRUE(driven.said("the IMU is silent")) << driven.messages[0];
  EXPECT_NEAR(static_cast<double>(counted("gyro_silent")), 400.0, 5.0);
}

TEST_F(WheelImuTrouble, WheelsGoOnWhereTheGyroNeverComes) {
  gyro.clear();
  expectRightHeading(0.3);
  ASSERT_EQ(driven.messages.size(), 1u);
  EXPECT_TRUE(driven.said("see whether its driver runs")) << driven.messages[0];
}

TEST_F(WheelImuTrouble, AShortHoleIsCountedAndNotWorthAWord) {
  leaveOut(12.0, 12.4);
  expectRightHeading();
  EXPECT_TRUE(driven.messages.empty());
  EXPECT_GT(counted("gyro_silent"), 10u);
}

TEST_F(WheelImuTrouble, AValueThatIsStuckIsNotBelieved) {
  double rate = 0.0;
  change(0, 12.0, [&](auto& sample) { rate = sample.angular_velocity.z(); });
  change(12.0, 30.0, [&](auto& sample) { sample.angular_velocity.z() = rate; });
  expectRightHeading(0.15);
  ASSERT_FALSE(driven.messages.empty());
  EXPECT_TRUE(driven.said("repeats one angular velocity")) << driven.messages[0];
  EXPECT_LE(driven.messages.size(), 2u);
  EXPECT_GT(counted("gyro_stuck"), 100u);
}

TEST_F(WheelImuTrouble, ABurstIsNotBelieved) {
  change(14.0, 14.5, [](auto& sample) { sample.angular_velocity.z() += 30.0; });
  change(20.0, 20.2, [](auto& sample) { sample.angular_velocity.z() -= 200.0; });
  for (const double second : {10.0, 17.0, 24.0, 26.0, 28.0})  // the robot turns
    change(second, second + 0.5, [](auto& sample) { sample.angular_velocity.z() += 30.0; });
  expectRightHeading();
  ASSERT_FALSE(driven.messages.empty());
  EXPECT_TRUE(driven.said("faster than robots spin")) << driven.messages[0];
  EXPECT_FALSE(driven.said("counts in degrees")) << "they do not refute a proven gyro";
  EXPECT_GE(counted("gyro_implausible"), 20U);
}

TEST_F(WheelImuTrouble, AGyroOfZerosIsNotBelieved) {
  change(0, 1e9, [](auto& sample) { sample.angular_velocity.setZero(); });
  expectRightHeading(0.15);
  EXPECT_TRUE(driven.said("repeats one angular velocity"));
}

TEST_F(WheelImuTrouble, StampsThatJumpAreLeftOut) {
  const auto far = std::chrono::seconds(3000);
  for (const std::size_t i : {500, 900, 1300}) gyro[i].stamp += far;
  gyro[1500].stamp -= far;
  gyro[1600].stamp -= std::chrono::milliseconds(35);
  expectRightHeading();
  EXPECT_EQ(counted("gyro_stamp_jump"), 4u);
  EXPECT_EQ(counted("gyro_late"), 1u);
}

TEST_F(WheelImuTrouble, AClockThatIsFarOffLeavesTheHeadingToTheWheels) {
  change(0, 1e9, [](auto& sample) { sample.stamp -= std::chrono::hours(1); });
  expectRightHeading(0.3);
  EXPECT_TRUE(driven.said("whether its stamps are right"));
}

TEST_F(WheelImuTrouble, BothClocksMayStartOver) {
  driven.take(robot);
  auto again = robot;
  auto wheels = robot.wheels();
  for (auto& sample : wheels) sample.stamp -= std::chrono::hours(1);
  change(0, 1e9, [](auto& sample) { sample.stamp -= std::chrono::hours(1); });
  const auto before = driven.motions.size();
  driven.take(wheels, gyro);
  EXPECT_GT(driven.motions.size(), before + wheels.size() - 60);
  const auto& last = driven.motions.back();
  EXPECT_EQ(last.end, wheels.back().stamp);
}

}  // namespace
}  // namespace slam::imu_odometry
