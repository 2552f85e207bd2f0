// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu_odometry/turned_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/test/numeric_jacobian.hpp"
#include "slam_core/models/arc_jacobian.hpp"
#include "slam_core/models/motion_model.hpp"

namespace slam::imu_odometry {
namespace {

using gyro::GyroTurn;

Motion wheels(const Eigen::Vector3d& twist, const Eigen::Matrix3d& covariance) {
  Motion motion;
  motion.end = motion.start + std::chrono::seconds(1);
  motion.increment = Pose2::exp(twist);
  motion.covariance = covariance;
  return motion;
}

/// A turn of so many pieces, all alike.
GyroTurn evenTurn(double angle, double bias = 0.0, int pieces = 10) {
  GyroTurn turn;
  turn.seconds = 1.0;
  turn.angle = angle + bias;
  turn.pieces.assign(static_cast<std::size_t>(pieces),
                     {turn.seconds / pieces, turn.angle / pieces});
  return turn;
}

constexpr double kBias = 0.03;  // [rad/s]

TEST(TurnedMotion, IsTheWheelsArcWithTheGyrosAngle) {
  const auto motion = turnedMotion(wheels({0.5, 0.1, 0.9}, 1e-4 * Eigen::Matrix3d::Identity()),
                                   evenTurn(0.6, kBias), kBias, 1e-6);
  EXPECT_LT((motion.increment.vector() - Pose2::exp({0.5, 0.1, 0.6}).vector()).norm(), 1e-12);
  EXPECT_EQ(faultOf(motion), "");
}

TEST(TurnedMotion, FollowsTheGyroWithinTheMotion) {
  GyroTurn turn;  // straight ahead, then on the spot's quarter turn, then straight ahead
  turn.pieces = {{1.0, 0.0}, {1e-9, M_PI_2}, {1.0, 0.0}};
  turn.seconds = 2.0 + 1e-9;
  turn.angle = M_PI_2;
  const auto motion =
      turnedMotion(wheels({2.0, 0.0, 1.0}, 1e-4 * Eigen::Matrix3d::Identity()), turn, 0.0, 1e-6);
  EXPECT_LT((motion.increment.vector() - Eigen::Vector3d(1.0, 1.0, M_PI_2)).norm(), 1e-6);
}

TEST(TurnedMotion, KeepsTheWheelsWayHoweverWrongTheirHeadingIs) {
  const LinearMotionModel model({0.01, 0.001, 0.002, 0.005, true});
  const Eigen::Vector3d twist(0.8, 0.0, 1.4);
  const auto motion =
      turnedMotion(wheels(twist, model.covariance(Pose2::exp(twist))), evenTurn(0.2), 0.0, 1e-6);
  EXPECT_LT((motion.increment.log() - Eigen::Vector3d(0.8, 0.0, 0.2)).norm(), 1e-12);
}

/// Against many motions whose way and turn are off as the covariances say.
TEST(TurnedMotion, HasTheCovarianceOfWayAndTurn) {
  Eigen::Matrix3d of_twist;
  of_twist << 4e-4, 1e-4, 0, 1e-4, 2e-4, 0, 0, 0, 9e-4;
  const Eigen::Vector3d twist(0.7, 0.0, 0.5);
  const Eigen::Matrix3d J = arcJacobian(twist);
  const auto motion =
      turnedMotion(wheels(twist, J * of_twist * J.transpose()), evenTurn(0.8), 0.0, 2.5e-3);
  Eigen::Matrix3d truth = of_twist;
  truth(2, 2) = 2.5e-3;
  const Eigen::Matrix3d L = truth.llt().matrixL();
  RandomStream random(1, 1);
  Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    const Eigen::Vector3d noise(random.gaussian(), random.gaussian(), random.gaussian());
    const Eigen::Vector3d off =
        Pose2::exp(Eigen::Vector3d(0.7, 0.0, 0.8) + L * noise).vector() - motion.increment.vector();
    sampled += off * off.transpose() / kSamples;
  }
  EXPECT_LT((sampled - motion.covariance).norm(), 0.05 * motion.covariance.norm());
  EXPECT_GT(motion.covariance(1, 2), 0.0) << "a heading that is wrong swings the way";
}

TEST(ArcJacobian, IsThatOfPose2Exp) {
  for (const double theta : {0.0, 1e-5, 0.3, -2.0}) {
    const Eigen::Vector3d twist(0.7, -0.2, theta);
    const auto arc = [](const Eigen::VectorXd& v) -> Eigen::VectorXd {
      return Pose2::exp(v).vector();
    };
    const auto minus = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) -> Eigen::VectorXd {
      return a - b;
    };
    const Eigen::MatrixXd numeric = slam::test::numericJacobian(arc, twist, minus);
    EXPECT_LT((arcJacobian(twist) - numeric).norm(), 1e-6) << theta;
  }
}

}  // namespace
}  // namespace slam::imu_odometry
