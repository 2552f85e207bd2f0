// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <string>
#include <vector>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/miscalibrated_robot.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

/// The share of the steps in which a pose is wrong by more than five reported sigmas and 0.1 m, of
/// a drive of two laps on which the odometry's way and the ranges have wrong scales, and all
/// bearings an offset [rad]. @param first the step from which on it counts
double confidentlyWrong(const std::string& backend, double way, double range, bool adapts,
                        double bearing = 0.0, int first = 50) {
  constexpr int kSteps = 250;
  Settings settings({}, {},
                    {std::string("consistency.adapt=") + (adapts ? "true" : "false"),
                     "relocalisation.enabled=false"});
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create(backend));
  estimator.configure(settings);
  test::SimulatedWorld world(3);
  int wrong = 0;
  for (int i = 0; i < kSteps; ++i) {
    auto step = world.next();
    const auto u = step.motion.increment.vector();
    step.motion.increment = Pose2(way * u.x(), way * u.y(), u.z());
    for (auto& z : step.observations.observations) {
      z.range *= range;
      z.bearing += bearing;
    }
    estimator.set(step.motion);
    estimator.set(step.observations);
    for (estimator.execute(); estimator.report(); estimator.execute()) {
      const auto& pose = estimator.report()->pose;
      const Eigen::Vector2d error = pose.pose.position() - step.truth.position();
      const Eigen::Matrix2d P = pose.covariance.topLeftCorner<2, 2>();
      const bool is_wrong = error.norm() > 0.1 && error.dot(P.inverse() * error) > 25.0;
      wrong += i >= first && is_wrong ? 1 : 0;
    }
  }
  return wrong / double(kSteps - first);
}

class AdverseDrive : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Backends, AdverseDrive, testing::Values("ekf", "graph"),
                         [](const auto& backend) { return backend.param; });

TEST_P(AdverseDrive, WheelsOfAWrongRadiusAreNotBelieved) {
  EXPECT_GT(confidentlyWrong(GetParam(), 0.8, 1.0, false), 0.2) << "as reported, they mislead";
  EXPECT_LT(confidentlyWrong(GetParam(), 0.8, 1.0, true), 0.02);
}

TEST_P(AdverseDrive, AMapWhoseScaleIsInDoubtIsReportedAsThat) {
  // from where most observations are gated the pose is reported as lost, with and without
  EXPECT_GT(confidentlyWrong(GetParam(), 1.0, 1.2, false), 0.05);
  EXPECT_LT(confidentlyWrong(GetParam(), 1.0, 1.2, true), 0.01);
}

/// Within the first metres, before a filter shows in its way what it believes of them.
TEST_P(AdverseDrive, ASensorThatIsMountedOtherwiseThanConfiguredIsNotBelieved) {
  constexpr int kFirst = 15;
  for (const double yaw : {0.1, -0.1}) {
    EXPECT_GT(confidentlyWrong(GetParam(), 1.0, 1.0, false, yaw, kFirst), 0.2) << yaw;
    EXPECT_LT(confidentlyWrong(GetParam(), 1.0, 1.0, true, yaw, kFirst), 0.01) << yaw;
  }
}

TEST_P(AdverseDrive, ARightOneStaysAsItIs) {
  EXPECT_EQ(confidentlyWrong(GetParam(), 1.0, 1.0, true), 0.0);
}

/// The doubts of a drive on which the wheels measure 0.7 of each motion, in steps after the
/// first 10.
int doubtfulSteps(const std::vector<std::string>& overrides) {
  Settings settings({}, {}, overrides);
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  CalibrationVector off = CalibrationVector::Zero();
  off(kWheelScale) = -std::log(0.7);
  test::MiscalibratedRobot robot(2, off);
  int doubtful = 0;
  for (int i = 0; i < 200; ++i) {
    const auto step = robot.next(i > 0);
    estimator.set(step.motion);
    estimator.set(step.observations);
    for (estimator.execute(); estimator.report(); estimator.execute())
      doubtful += i >= 10 && estimator.report()->trust != Trust::kConfident ? 1 : 0;
  }
  return doubtful;
}

TEST(CalibratedDrive, WheelsThatAreCalibratedAreNotDoubted) {
  EXPECT_GT(doubtfulSteps({}), 100);
  EXPECT_EQ(doubtfulSteps({"calibration.estimate=[wheel_scale]"}), 0);
}

/// Put elsewhere in its map without being told, a robot is found again although its ranges are
/// short.
TEST(CalibratedDrive, ARobotWithShortRangesIsFoundAgain) {
  Settings settings({}, {}, {"calibration.estimate=[range_scale]"});
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  CalibrationVector off = CalibrationVector::Zero();
  off(kRangeScale) = 0.2;
  test::MiscalibratedRobot robot(2, off);
  const auto drive = [&](int steps, bool moves) {
    Pose2 truth;
    for (int i = 0; i < steps; ++i) {
      const auto step = robot.next(moves && i > 0);
      estimator.set(step.motion);
      estimator.set(step.observations);
      for (estimator.execute(); estimator.report(); estimator.execute()) truth = step.truth;
    }
    return truth.between(estimator.backend().pose().pose).vector().norm();
  };
  EXPECT_LT(drive(150, true), 0.2);
  estimator.set(PoseEstimate{Pose2(40.0, 40.0, 0.0), 1e-4 * Eigen::Matrix3d::Identity()});
  relocaliserOf(estimator).assume(relocalisation::Belief::kAnywhere);
  EXPECT_LT(drive(60, true), 0.3);
}

TEST(NoiseOfAnEstimator, IsEnlargedWhereASigmaIsThreeTimesTooSmallUntilAReset) {
  Settings settings;
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  const auto factor = [&estimator] {
    for (const auto& [name, value] : estimator.figures())
      if (name == "bearing_noise_factor") return value;
    return 0.0;
  };
  EXPECT_EQ(factor(), 1.0);
  test::SimulatedWorld world(9);
  for (int i = 0; i < 200; ++i) {
    auto step = world.next();
    for (auto& z : step.observations.observations) z.covariance(1, 1) /= 9.0;
    estimator.set(step.motion);
    estimator.set(step.observations);
    do estimator.execute();
    while (estimator.report());
  }
  EXPECT_GT(factor(), 2.0);
  EXPECT_LT(factor(), 5.0);
  EXPECT_EQ(estimator.consistency().finding(), "") << "the noise is right now";
  estimator.reset();
  EXPECT_EQ(factor(), 1.0);
}

}  // namespace
}  // namespace slam
