// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/wheel_odometry/wheel_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "slam_core/common/test/faults.hpp"

namespace slam::wheel_odometry {
namespace {

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

OdometrySample poseSample(double stamp, const Pose2& pose) {
  OdometrySample sample;
  sample.stamp = at(stamp);
  sample.pose = pose;
  sample.odometry_frame = "odom";
  sample.base_frame = "base_link";
  return sample;
}

OdometrySample twistSample(double stamp, const Eigen::Vector3d& twist) {
  auto sample = poseSample(stamp, {});
  sample.pose.reset();
  sample.twist = twist;
  return sample;
}

void expectSame(const Pose2& a, const Pose2& b) {
  EXPECT_LT((a.vector() - b.vector()).norm(), 1e-12)
      << a.vector().transpose() << " and " << b.vector().transpose();
}

class WheelOdometryTest : public testing::Test {
 protected:
  void SetUp() override { odometry.configure(config); }
  Status take(const OdometrySample& sample) {
    odometry.set(sample);
    return odometry.execute();
  }
  const Motion& motion() const { return odometry.motion().value(); }

  WheelOdometryConfig config;
  WheelOdometry odometry;
};

TEST_F(WheelOdometryTest, GivesTheDisplacementBetweenTwoPoses) {
  const Pose2 first(1, 2, 3), step(0.1, 0.01, 0.2);
  EXPECT_TRUE(take(poseSample(5, first)).isOk());
  EXPECT_FALSE(odometry.motion().has_value()) << "one pose is no motion";
  EXPECT_TRUE(take(poseSample(5.1, first * step)).isOk());
  expectSame(motion().increment, step);
  EXPECT_EQ(motion().start, at(5));
  EXPECT_EQ(motion().end, at(5.1));
  expectSame(motion().odometry_start, first);
  expectSame(motion().odometry_end, first * step);
  EXPECT_EQ(motion().odometry_frame, "odom");
  EXPECT_EQ(motion().base_frame, "base_link");
  EXPECT_EQ(faultOf(motion()), "");
}

TEST_F(WheelOdometryTest, CountsItsMotionsFromZeroWithoutGaps) {
  for (int i = 0; i < 5; ++i) {
    take(poseSample(i, Pose2(i, 0, 0)));
    if (i == 2) take(poseSample(i, Pose2(i, 0, 0)));  // late, no motion
    if (odometry.motion()) {
      EXPECT_EQ(motion().sequence, std::uint64_t(i - 1));
    }
  }
}

TEST_F(WheelOdometryTest, HoldsATwistUntilTheNextMessage) {
  take(twistSample(0, {1, 0, 0.5}));
  take(twistSample(2, {0, 0, 0}));
  expectSame(motion().increment, Pose2::exp({2, 0, 1}));
  take(twistSample(3, {7, 7, 7}));
  expectSame(motion().increment, Pose2());
  expectSame(motion().odometry_end, Pose2::exp({2, 0, 1}));  // it integrates the pose itself
}

TEST_F(WheelOdometryTest, IsUncertainWhereATwistIsHeldForLong) {
  for (int i = 0; i < 10; ++i) take(twistSample(0.1 * i, {1, 0, 0.5}));
  const double usual = motion().covariance(0, 0);
  take(twistSample(4.9, {1, 0, 0.5}));
  expectSame(motion().increment, Pose2::exp({4, 0, 2}));
  EXPECT_GT(motion().covariance(0, 0), 4.0 * 4.0) << "it may have turned back at once";
  EXPECT_LT(usual, 1e-2);
}

TEST_F(WheelOdometryTest, UsesTheTwistBesideAPoseWhenToldSo) {
  config.increment = WheelOdometryConfig::Increment::kTwist;
  odometry.configure(config);
  auto first = poseSample(0, Pose2(1, 1, 0)), second = poseSample(1, Pose2(5, 5, 1));
  first.twist = {0.5, 0, 0};
  take(first);
  take(second);
  expectSame(motion().increment, Pose2(0.5, 0, 0));
  expectSame(motion().odometry_end, Pose2(5, 5, 1));  // map -> odom must fit the driver's TF
}

TEST_F(WheelOdometryTest, SaysThatADriverSetsNoStamps) {
  take(poseSample(0, Pose2()));
  EXPECT_EQ(take(poseSample(0, Pose2(1, 0, 0))).message,
            "odometry has the stamp 0, since its driver sets none; it is left out");
}

TEST_F(WheelOdometryTest, RefusesStampsThatAreNotNewer) {
  take(poseSample(1, Pose2()));
  take(poseSample(2, Pose2(1, 0, 0)));
  for (const double stamp : {2.0, 1.5}) {
    const auto status = take(poseSample(stamp, Pose2(9, 0, 0)));
    EXPECT_EQ(status.level, Status::Level::kWarning);
    EXPECT_FALSE(odometry.motion().has_value());
  }
  EXPECT_EQ(odometry.counters()["late"], 2u);
  take(poseSample(3, Pose2(2, 0, 0)));
  expectSame(motion().increment, Pose2(1, 0, 0));
}

TEST_F(WheelOdometryTest, BeginsAnewWhenTheBagDoes) {
  take(poseSample(100, Pose2(50, 0, 0)));
  take(poseSample(10, Pose2()));
  EXPECT_FALSE(odometry.motion().has_value()) << "the jump is no motion";
  take(poseSample(11, Pose2(1, 0, 0)));
  expectSame(motion().increment, Pose2(1, 0, 0));
}

TEST_F(WheelOdometryTest, LosesNothingToOneStampFarAhead) {
  take(poseSample(1, Pose2()));
  EXPECT_FALSE(take(poseSample(4000, Pose2(1, 0, 0))).isOk());
  EXPECT_FALSE(odometry.motion().has_value());
  EXPECT_TRUE(take(poseSample(1.2, Pose2(2, 0, 0))).isOk());
  EXPECT_EQ(motion().start, at(1));
  EXPECT_EQ(motion().end, at(1.2));
  expectSame(motion().increment, Pose2(2, 0, 0));
  EXPECT_EQ(odometry.counters()["stamp_jump"], 1u);
}

TEST_F(WheelOdometryTest, SpansAGapOnceTwoMessagesAreBehindIt) {
  take(poseSample(1, Pose2()));
  take(poseSample(10, Pose2(1, 0, 0)));
  EXPECT_TRUE(take(poseSample(10.1, Pose2(2, 0, 0))).isOk());
  EXPECT_EQ(motion().start, at(1));
  expectSame(motion().increment, Pose2(2, 0, 0));
}

TEST_F(WheelOdometryTest, LeavesOutWhatIsNotANumber) {
  take(poseSample(0, Pose2()));
  EXPECT_FALSE(take(poseSample(1, Pose2(std::nan(""), 0, 0))).isOk());
  EXPECT_FALSE(take(twistSample(1, {0, INFINITY, 0})).isOk());
  EXPECT_FALSE(odometry.motion().has_value());
  EXPECT_EQ(odometry.counters()["invalid"], 2u);
  take(poseSample(2, Pose2(1, 0, 0)));
  expectSame(motion().increment, Pose2(1, 0, 0));
}

TEST_F(WheelOdometryTest, BeginsAnewWhenAFrameChanges) {
  take(poseSample(0, Pose2()));
  auto other = poseSample(1, Pose2(9, 9, 0));
  other.odometry_frame = "other_odom";
  const auto status = take(other);
  EXPECT_TRUE(test::oneSays({status.message}, {"other_odom", "base_link"}));
  EXPECT_FALSE(odometry.motion().has_value());
  EXPECT_EQ(odometry.counters()["frame_change"], 1u);
  other.stamp = at(2);
  other.pose = Pose2(10, 9, 0);
  EXPECT_TRUE(take(other).isOk());
  expectSame(motion().increment, Pose2(1, 0, 0));
}

TEST_F(WheelOdometryTest, IsNeverCertainNotEvenStandingStill) {
  take(poseSample(0, Pose2()));
  take(poseSample(2, Pose2()));
  EXPECT_TRUE(isCovariance(motion().covariance));
  EXPECT_NEAR(motion().covariance(0, 0), 2 * std::pow(config.floor_position, 2), 1e-18);
  EXPECT_NEAR(motion().covariance(2, 2), 2 * std::pow(config.floor_heading, 2), 1e-18);
}

TEST_F(WheelOdometryTest, AddsTheModelsCovarianceToTheFloor) {
  const Pose2 step(0.5, 0.1, 0.3);
  take(poseSample(0, Pose2()));
  take(poseSample(1, step));
  const LinearMotionModel model({config.alpha1, config.alpha2, config.alpha3, config.alpha4});
  Eigen::Matrix3d expected = model.covariance(step);
  expected.diagonal().array() += 1e-6;  // floors of 0.001 after one second
  EXPECT_TRUE(motion().covariance.isApprox(expected, 1e-9));
}

TEST_F(WheelOdometryTest, TakesTheTwistsCovarianceWhenToldSo) {
  config.covariance = WheelOdometryConfig::Covariance::kTwist;
  odometry.configure(config);
  auto sample = twistSample(0, {1, 0, 0});
  sample.twist_covariance = Eigen::Vector3d(0.04, 0.01, 0.09).asDiagonal();
  take(sample);
  take(twistSample(0.5, {1, 0, 0}));  // it holds no covariance of its own
  EXPECT_NEAR(motion().covariance(0, 0), 0.25 * 0.04, 1e-5);
  EXPECT_NEAR(motion().covariance(2, 2), 0.25 * 0.09, 1e-5);
  take(twistSample(1.0, {1, 0, 0}));
  EXPECT_NEAR(motion().covariance(0, 0), config.alpha1 * 0.5, 1e-5) << "the model steps in";
}

TEST_F(WheelOdometryTest, TakesOutTheSystematicErrorOfTheWheels) {
  config.translation_scale = 0.9;
  config.rotation_scale = 1.2;
  config.drift = -0.1;
  odometry.configure(config);
  const Pose2 measured = Pose2::exp({1, 0, 0.5});
  take(poseSample(0, Pose2()));
  take(poseSample(1, measured));
  expectSame(motion().increment, Pose2::exp({0.9, 0, 0.6 - 0.09}));
  expectSame(motion().odometry_end, measured);
}

/// Ahead at 1 m/s, 20 messages a second, to the pose that is given for the message.
class DrivenWheelsTest : public WheelOdometryTest {
 protected:
  template <class PoseOf>
  void drive(int messages, const PoseOf& poseOf, const Eigen::Vector3d& twist = {0, 0, 0}) {
    for (int i = 0; i < messages; ++i) {
      auto sample = poseSample(0.05 * i, poseOf(i));
      sample.twist = twist;
      if (const auto status = take(sample); !status.isOk()) sentences.push_back(status.message);
      if (!odometry.motion()) continue;
      EXPECT_EQ(faultOf(motion()), "") << i;
      EXPECT_EQ(motion().start, end) << "no time is left out";
      end = motion().end;
      covariance += motion().covariance;
      way = way * motion().increment;
    }
  }
  static Pose2 ahead(int i) { return {5 + 0.05 * i, 1, 0}; }

  Stamp end = at(0);
  Pose2 way;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::vector<std::string> sentences;
};

TEST_F(DrivenWheelsTest, ADriverThatBeginsAtTheOriginAgainMovesNothing) {
  drive(40, [](int i) { return i < 20 ? ahead(i) : Pose2(0.05 * (i - 20), 0, 0); });
  EXPECT_LT((way.position() - Eigen::Vector2d(39 * 0.05, 0)).norm(), 0.001);
  EXPECT_EQ(odometry.counters()["pose_jump"], 1u);
  EXPECT_EQ(odometry.counters()["implausible"], 1u);
  EXPECT_TRUE(test::oneSays(sentences, {"pose jumped", "goes on from the new one"}));
  expectSame(motion().odometry_end, Pose2(0.05 * 19, 0, 0));
}

TEST_F(DrivenWheelsTest, ADriverThatBeginsAtTheOriginNearByIsSeenAsWell) {
  drive(40, [](int i) { return i < 20 ? ahead(i) : Pose2(0.05 * (i - 20), 0, 0); });
  const auto far = way;
  SetUp();
  end = at(0);
  way = Pose2();
  drive(40, [](int i) {
    return i < 20 ? Pose2(-0.5 + 0.05 * i, 0.3, 0) : Pose2(0.05 * (i - 20), 0, 0);
  });
  EXPECT_LT((way.vector() - far.vector()).norm(), 1e-9);
  EXPECT_EQ(odometry.counters()["pose_jump"], 1u);
}

TEST_F(DrivenWheelsTest, ADriverThatIsSilentAndBeginsAtTheOriginHasNotDrivenThere) {
  for (const double pause : {1.0, 3.0, 8.0}) {
    SetUp();
    for (int i = 0; i < 20; ++i) take(poseSample(0.05 * i, Pose2(20 + 0.05 * i, 1, 0)));
    take(poseSample(1.0 + pause, Pose2(0.01, 0, 0.01)));
    take(poseSample(1.05 + pause, Pose2(0.06, 0, 0.01)));
    EXPECT_EQ(odometry.counters()["pose_jump"], 1u) << pause;
    EXPECT_EQ(motion().start, at(0.95));
    EXPECT_NEAR(motion().increment.x(), 0.05 + 0.05 + pause, 0.01) << "as before";
    EXPECT_GT(motion().covariance(0, 0), std::pow(0.9 * pause, 2)) << "or not";
    EXPECT_EQ(faultOf(motion()), "");
  }
}

TEST_F(DrivenWheelsTest, ADriverThatPassesItsOriginHasNotJumped) {
  drive(40, [](int i) { return Pose2(-1 + 0.05 * i, 0, 0); });
  EXPECT_TRUE(odometry.counters().all().empty());
}

TEST_F(DrivenWheelsTest, AJumpIsCrossedByTheTwistWhereThereIsOne) {
  // turns as well, only in the message before the jump
  drive(20, ahead, {1.0, 0.0, 0.0});
  auto turning = poseSample(1.0, ahead(20));
  turning.twist = {1.0, 0.0, 2.0};
  take(turning);
  take(poseSample(1.05, Pose2(100, 100, 0)));
  EXPECT_FALSE(odometry.motion());
  EXPECT_FALSE(take(poseSample(1.1, Pose2(100.05, 100, 0))).isOk());
  expectSame(motion().increment, Pose2::exp({0.05, 0, 0.1}) * Pose2(0.05, 0, 0));
  expectSame(motion().odometry_end, Pose2(100.05, 100, 0));
  EXPECT_EQ(motion().start, at(1.0));
}

TEST_F(DrivenWheelsTest, AJumpLeavesDoubtToMatch) {
  drive(40, ahead);
  const auto without = covariance;
  SetUp();
  end = at(0);
  covariance.setZero();
  drive(40, [](int i) { return i < 20 ? ahead(i) : Pose2(70, 0.05 * i, M_PI / 2); });
  EXPECT_GT(covariance(0, 0), without(0, 0) + std::pow(0.005, 2));
  EXPECT_GT(covariance(1, 1), without(1, 1) + std::pow(0.005, 2));
  EXPECT_LT(covariance(0, 0), without(0, 0) + std::pow(0.1, 2));
}

TEST_F(DrivenWheelsTest, OnePoseThatIsOffAndComesBackIsLeftOut) {
  for (const double off : {3.0, 1e6, 1e8, 1e300}) {
    SetUp();
    end = at(0);
    way = Pose2();
    drive(40, [&](int i) { return i == 20 ? Pose2(off, off, 1) : ahead(i); });
    EXPECT_LT((way.position() - Eigen::Vector2d(39 * 0.05, 0)).norm(), 1e-9) << off;
    EXPECT_EQ(odometry.counters()["implausible"] + odometry.counters()["invalid"], 1u);
    EXPECT_EQ(odometry.counters()["pose_jump"], 0u);
  }
}

TEST_F(DrivenWheelsTest, AFirstPoseThatIsOffIsForgotten) {
  drive(40, [&](int i) { return i == 0 ? Pose2(1e6, 0, 0) : ahead(i); });
  EXPECT_LT((way.position() - Eigen::Vector2d(38 * 0.05, 0)).norm(), 1e-9);
}

TEST_F(DrivenWheelsTest, MessagesInBurstsAreBelieved) {
  double stamp = 0.0;
  for (int i = 0; i < 40; ++i, stamp += i % 5 == 0 ? 0.2496 : 1e-4) {
    EXPECT_TRUE(take(poseSample(stamp, ahead(i))).isOk()) << i;
  }
}

TEST_F(DrivenWheelsTest, ASlipOfTheHeadingIsBelieved) {
  drive(40, [](int i) { return ahead(i) * Pose2(0, 0, i < 20 ? 0.0 : 0.3); });
  EXPECT_TRUE(odometry.counters().all().empty());
}

TEST_F(DrivenWheelsTest, ATwistBeyondTheLimitIsReplacedByTheLastVelocity) {
  for (int i = 0; i < 10; ++i) take(twistSample(0.1 * i, {1, 0, 0}));
  for (const double fast : {100.0, 1e300}) {
    const double begin = fast > 1e3 ? 2.0 : 1.0;
    take(twistSample(begin, {fast, 0, 0}));
    EXPECT_FALSE(take(twistSample(begin + 0.1, {1, 0, 0})).isOk());
    expectSame(motion().increment, Pose2(0.1, 0, 0));
    EXPECT_EQ(faultOf(motion()), "");
  }
  EXPECT_EQ(odometry.counters()["implausible"], 2u);
}

TEST_F(DrivenWheelsTest, TheLargestSpeedIsTheRobots) {
  config.max_speed = 0.5;
  odometry.configure(config);
  drive(20, [](int i) { return Pose2(0.1 * i, 0, 0); });  // 2 m/s
  EXPECT_GT(odometry.counters()["implausible"], 10u);
  EXPECT_TRUE(test::oneSays(sentences, {"wheel_odometry.max_speed"}));
}

TEST_F(WheelOdometryTest, ForgetsEverythingOnReset) {
  take(poseSample(1, Pose2()));
  take(poseSample(0.5, Pose2()));
  odometry.reset();
  EXPECT_TRUE(odometry.counters().all().empty());
  take(poseSample(0, Pose2(3, 0, 0)));
  EXPECT_FALSE(odometry.motion().has_value());
  take(poseSample(1, Pose2(4, 0, 0)));
  EXPECT_EQ(motion().sequence, 0u);
  expectSame(motion().increment, Pose2(1, 0, 0));
}

TEST(WheelOdometryConfigTest, ListsAllFaultsOfItsSection) {
  const auto faults = test::faultsOf([] {
    Settings settings({"product.yaml", YAML::Load("{version: 1, wheel_odometry: {alpha1: 0.1}}")},
                      {"robot.yaml", YAML::Load("{version: 1, wheel_odometry: {alpha2: -1, alpha7: "
                                                "1, drive: tracked, increment: velocity, "
                                                "floor_heading: 0, rotation_scale: 0}}")},
                      {"wheel_odometry.motion_model=quadratc", "wheel_odometry.alpha3=.nan"});
    WheelOdometry().configure(settings);
  });
  EXPECT_EQ(faults.size(), 9u);
  EXPECT_TRUE(test::oneSays(faults, {"alpha1", "product.yaml", "belongs in the robot file"}));
  EXPECT_TRUE(test::oneSays(faults, {"alpha2", "-1", ">= 0"}));
  EXPECT_TRUE(test::oneSays(faults, {"alpha7", "unknown", "did you mean 'alpha"}));
  EXPECT_TRUE(test::oneSays(faults, {"drive", "'tracked'", "differential, omnidirectional"}));
  EXPECT_TRUE(test::oneSays(faults, {"increment", "'velocity'", "pose, twist"}));
  EXPECT_TRUE(test::oneSays(faults, {"floor_heading", "> 0"}));
  EXPECT_TRUE(test::oneSays(faults, {"rotation_scale", "(0, 10)"}));
  EXPECT_TRUE(test::oneSays(faults, {"motion_model", "did you mean 'quadratic'"}));
  EXPECT_TRUE(test::oneSays(faults, {"alpha3", "nan"}));
}

}  // namespace
}  // namespace slam::wheel_odometry
