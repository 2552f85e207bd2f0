// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/dead_reckoning.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "slam_core/models/calibration.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam {
namespace {

constexpr double kStep = 0.05;  // [m]
// Of a metre, as an odometry's alphas say it.
const Eigen::Vector3d kPerMetre(1e-4, 1e-6, 2e-4);

Motion motionBy(const Pose2& increment) {
  Motion motion;
  motion.increment = increment;
  const double way = increment.position().norm() + std::abs(increment.theta());
  motion.covariance = (way * kPerMetre).asDiagonal();
  return motion;
}

/// Beside it a filter that only predicts.
class DeadReckoningTest : public testing::Test {
 protected:
  void drive(const Pose2& increment, int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto motion = motionBy(increment);
      reckoning.predict(motion);
      Eigen::Matrix3d J_pose, J_step;
      pose.pose = pose.pose.compose(motion.increment, &J_pose, &J_step);
      pose.covariance = J_pose * pose.covariance * J_pose.transpose() +
                        J_step * motion.covariance * J_step.transpose();
    }
  }
  Eigen::Matrix3d added() const { return reckoning.covarianceAt(pose.pose); }
  Eigen::Matrix3d reported() const { return pose.covariance + added(); }

  DeadReckoning reckoning;
  PoseEstimate pose;
};

TEST_F(DeadReckoningTest, LeavesTheNoiseOfAMetreAsItIs) {
  drive({kStep, 0, 0}, 19);
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
}

TEST_F(DeadReckoningTest, ErrorsOfLongWaysGrowWithTheWay) {
  drive({kStep, 0, 0}, 20);
  const double of_a_metre = std::sqrt(reported()(0, 0));
  drive({kStep, 0, 0}, 180);
  EXPECT_NEAR(std::sqrt(reported()(0, 0)), 10 * of_a_metre, 0.05 * 10 * of_a_metre);
}

TEST_F(DeadReckoningTest, ACorrectionBeginsANewWay) {
  drive({kStep, 0, 0}, 100);
  reckoning.correct();
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
  drive({kStep, 0, 0}, 19);
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
}

TEST_F(DeadReckoningTest, ARobotThatStandsLosesNothing) {
  drive({kStep, 0, 0}, 100);
  const auto before = added();
  drive({}, 100);
  EXPECT_NEAR((added() - before).norm(), 0.0, 1e-9 * before.norm());
}

ObservationInnovation used(LandmarkId id) {
  ObservationInnovation innovation;
  innovation.id = id;
  innovation.used = true;
  return innovation;
}

/// Landmark 1 was seen at the start, landmark 2 after a long way.
TEST_F(DeadReckoningTest, ALandmarkLeavesWhatWentBeforeIt) {
  reckoning.correct({used(1)}, pose.pose);
  drive({kStep, 0, 0}, 100);
  const auto of_the_way = added();
  reckoning.correct({used(2)}, pose.pose);
  EXPECT_EQ(added(), of_the_way);
  drive({kStep, 0, 0}, 100);
  EXPECT_GT(added()(0, 0), of_the_way(0, 0));
  reckoning.correct({used(2)}, pose.pose);
  EXPECT_EQ(added(), of_the_way);
  reckoning.correct({used(2), used(1)}, pose.pose);
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
  reckoning.correct({used(2)}, pose.pose);  // which the first one has not corrected
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
}

TEST_F(DeadReckoningTest, ALandmarkThatIsGatedCorrectsNothing) {
  reckoning.correct({used(1)}, pose.pose);
  drive({kStep, 0, 0}, 100);
  const auto of_the_way = added();
  auto gated = used(1);
  gated.used = false;
  reckoning.correct({gated}, pose.pose);
  EXPECT_EQ(added(), of_the_way);
}

/// The pose is corrected by things first seen at the start, on the way and after a long way.
TEST_F(DeadReckoningTest, WhatHasNoIdsCorrectsWhatCameAfterItWasFirstSeen) {
  const auto at = [](int second) { return Stamp(std::chrono::seconds(second)); };
  reckoning.correct(at(1), at(1), pose.pose);
  drive({kStep, 0, 0}, 100);
  const auto of_the_way = added();
  reckoning.correct(at(2), at(3), pose.pose);
  EXPECT_EQ(added(), of_the_way);
  drive({kStep, 0, 0}, 100);
  EXPECT_GT(added()(0, 0), of_the_way(0, 0));
  reckoning.correct(at(3), at(5), pose.pose);
  EXPECT_EQ(added(), of_the_way);
  reckoning.correct(at(1), at(6), pose.pose);
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
  reckoning.correct(at(7), at(7), pose.pose);
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
}

TEST_F(DeadReckoningTest, WhatIsFirstSeenAfterALongWayLeavesIt) {
  drive({kStep, 0, 0}, 100);
  const auto of_the_way = added();
  reckoning.correct(Stamp(std::chrono::seconds(9)), Stamp(std::chrono::seconds(9)), pose.pose);
  EXPECT_EQ(added(), of_the_way);
}

TEST_F(DeadReckoningTest, LandmarksOfALoadedMapAreWhereItSays) {
  LandmarkMap map(1);
  map.front().id = 1;
  reckoning.know(map);
  drive({kStep, 0, 0}, 100);
  reckoning.correct({used(1)}, pose.pose);
  EXPECT_EQ(added(), Eigen::Matrix3d::Zero());
}

/// In whatever direction of the map the way began.
TEST_F(DeadReckoningTest, TurnsWithTheMap) {
  drive({kStep, 0, 0.01}, 100);
  const Pose2 turn(0, 0, 0.7);
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = turn.rotation();
  const Eigen::Matrix3d expected = R * added() * R.transpose();
  EXPECT_TRUE(reckoning.covarianceAt(turn * pose.pose).isApprox(expected, 1e-9));
}

/// After a day without a landmark the heading is unknown, and no more can be: numbers stay such
/// that programs can compute with them.
TEST_F(DeadReckoningTest, CovariancesStayWithinBounds) {
  for (int i = 0; i < 100'000; ++i) {
    drive({kStep, 0, i % 7 == 0 ? 0.3 : -0.05}, 10);
    const Eigen::Vector3d eigenvalues = added().selfadjointView<Eigen::Lower>().eigenvalues();
    ASSERT_GT(eigenvalues.minCoeff(), -1e-6 * eigenvalues.maxCoeff()) << "step " << i;
    ASSERT_LT(eigenvalues.maxCoeff(), 1e12) << "step " << i;
  }
}

/// The error of wheels whose sizes differ is the same on the whole way: Monte Carlo over such
/// wheels along straight ways and curves, with the variance that a metre of them has.
class WrongWheels : public DeadReckoningTest, public testing::WithParamInterface<double> {};

TEST_P(WrongWheels, AreCoveredAlongTheWholeWay) {
  const Pose2 increment(kStep, 0, GetParam());
  constexpr int kWheels = 300, kSteps = 300;
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  const double per_metre = 1.0 + std::abs(GetParam()) / kStep;
  double nees = 0.0;
  drive(increment, kSteps);
  for (int i = 0; i < kWheels; ++i) {
    CalibrationVector wheels = CalibrationVector::Zero();
    wheels[kWheelScale] = std::sqrt(kPerMetre[0] * per_metre) * normal(engine);
    wheels[kWheelDrift] = std::sqrt(kPerMetre[2] * per_metre) * normal(engine);
    Pose2 truth;
    for (int step = 0; step < kSteps; ++step) truth = truth * calibrated(increment, wheels);
    Eigen::Vector3d error = truth.vector() - pose.pose.vector();
    error.z() = std::remainder(error.z(), 2 * M_PI);
    nees += error.dot(reported().ldlt().solve(error)) / kWheels;
  }
  EXPECT_LT(nees, 3.5);  // 3 of an exact covariance
  EXPECT_GT(nees, 0.2);  // not beyond all measure
}

INSTANTIATE_TEST_SUITE_P(On, WrongWheels, testing::Values(0.0, 0.01, 0.05, -0.02));

}  // namespace
}  // namespace slam
