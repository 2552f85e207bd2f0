// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/pose2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam {
namespace {

Eigen::Vector3d difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.x() - b.x(), a.y() - b.y(), wrapAngle(a.z() - b.z())};
}

/// As homogeneous coordinates, the definition that everything is checked against.
Eigen::Matrix3d matrix(const Pose2& pose) {
  Eigen::Matrix3d T = Eigen::Matrix3d::Identity();
  T.topLeftCorner<2, 2>() << std::cos(pose.theta()), -std::sin(pose.theta()),
      std::sin(pose.theta()), std::cos(pose.theta());
  T.topRightCorner<2, 1>() = pose.position();
  return T;
}

void expectSame(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_LT(difference(a.vector(), b.vector()).cwiseAbs().maxCoeff(), tolerance)
      << a.vector().transpose() << " and " << b.vector().transpose();
}

/// Every property must hold for each of these, and for pairs of them.
std::vector<Pose2> examples() {
  std::vector<Pose2> poses = {Pose2(),
                              Pose2(1, 2, 0),
                              Pose2(0, 0, M_PI),
                              Pose2(1, -1, M_PI - 1e-9),
                              Pose2(-2, 1, -M_PI + 1e-9),
                              Pose2(3, 1, 1e-9),
                              Pose2(3, 1, 0.99e-4),
                              Pose2(3, 1, 1.01e-4),
                              Pose2(1e-9, -1e-9, -1e-9),
                              Pose2(1e3, -2e3, M_PI / 2)};
  RandomStream random(1, 0);
  for (int i = 0; i < 30; ++i)
    poses.emplace_back(3 * random.gaussian(), 3 * random.gaussian(), 2 * random.gaussian());
  return poses;
}

TEST(Pose2, ComposesAsItsMatricesDo) {
  for (const auto& a : examples())
    for (const auto& b : examples())
      EXPECT_TRUE(matrix(a * b).isApprox(matrix(a) * matrix(b), 1e-12));
}

TEST(Pose2, InverseUndoesThePose) {
  for (const auto& a : examples()) {
    expectSame(a * a.inverse(), Pose2(), 1e-12);
    expectSame(a.inverse() * a, Pose2(), 1e-12);
    for (const auto& b : examples()) expectSame(a * a.between(b), b, 1e-11);
  }
}

TEST(Pose2, ComposeHasTheNumericJacobians) {
  for (const auto& a : examples())
    for (const auto& b : examples()) {
      if (a.position().norm() + b.position().norm() > 100) continue;  // digits of the difference
      Eigen::Matrix3d J_a, J_b;
      a.compose(b, &J_a, &J_b);
      const auto of_a = [&](const Eigen::Vector3d& v) {
        return (Pose2::fromVector(v) * b).vector();
      };
      const auto of_b = [&](const Eigen::Vector3d& v) {
        return (a * Pose2::fromVector(v)).vector();
      };
      ASSERT_LT((J_a - test::numericJacobian(of_a, a.vector(), difference)).norm(), 1e-8);
      ASSERT_LT((J_b - test::numericJacobian(of_b, b.vector(), difference)).norm(), 1e-8);
    }
}

TEST(Pose2, InverseHasTheNumericJacobian) {
  for (const auto& a : examples()) {
    if (a.position().norm() > 100) continue;
    Eigen::Matrix3d J;
    a.inverse(&J);
    const auto f = [](const Eigen::Vector3d& v) { return Pose2::fromVector(v).inverse().vector(); };
    EXPECT_LT((J - test::numericJacobian(f, a.vector(), difference)).norm(), 1e-8);
  }
}

TEST(Pose2, TransformsPointsWithTheNumericJacobians) {
  const Eigen::Vector2d p(0.7, -1.3);
  const auto minus = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return Eigen::Vector2d(a - b);
  };
  for (const auto& a : examples()) {
    if (a.position().norm() > 100) continue;
    Eigen::Matrix<double, 2, 3> J_pose;
    Eigen::Matrix2d J_point;
    const Eigen::Vector3d expected = matrix(a) * Eigen::Vector3d(p.x(), p.y(), 1);
    EXPECT_TRUE(a.transform(p, &J_pose, &J_point).isApprox(expected.head<2>(), 1e-12));
    const auto of_pose = [&](const Eigen::Vector3d& v) {
      return Pose2::fromVector(v).transform(p);
    };
    const auto of_point = [&](const Eigen::Vector2d& v) { return a.transform(v); };
    EXPECT_LT((J_pose - test::numericJacobian(of_pose, a.vector(), minus)).norm(), 1e-8);
    EXPECT_LT((J_point - test::numericJacobian(of_point, p, minus)).norm(), 1e-8);
  }
}

TEST(Pose2, LogUndoesExpAndExpUndoesLog) {
  for (const auto& a : examples()) {
    expectSame(Pose2::exp(a.log()), a, 1e-12 * (1 + a.position().norm()));
    const Eigen::Vector3d twist = a.vector();
    EXPECT_LT((Pose2::exp(twist).log() - twist).norm(), 1e-9 * (1 + twist.norm()));
  }
}

TEST(Pose2, ExpFollowsAnArcOfTheTwistsRadius) {
  expectSame(Pose2::exp({M_PI / 2, 0, M_PI / 2}), Pose2(1, 1, M_PI / 2), 1e-15);
  expectSame(Pose2::exp({0, M_PI, M_PI}), Pose2(-2, 0, M_PI), 1e-15);
  expectSame(Pose2::exp({2, 1, 0}), Pose2(2, 1, 0), 1e-15);
}

TEST(Pose2, ExpKeepsItsDigitsAtSmallAngles) {
  for (const double angle : {1e-12, 1e-7, 0.9e-4, 1.1e-4, 1e-3, 1e-2}) {
    const long double t = angle, half = std::sin(t / 2);
    const Pose2 pose = Pose2::exp({1, 0, angle});
    EXPECT_NEAR(pose.x(), double(std::sin(t) / t), 4e-16);
    const double y = double(2 * half * half / t);
    EXPECT_NEAR(pose.y(), y, 1e-15 * y) << "angle " << angle;
  }
}

TEST(Pose2, ExpIsTheLimitOfManySmallSteps) {
  const Eigen::Vector3d twist(1.2, -0.4, 2.0);
  Pose2 pose;
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3d step = twist / kSteps;
    pose = pose * Pose2(step.x(), step.y(), step.z());
  }
  expectSame(Pose2::exp(twist), pose, 1e-5);
}

TEST(Pose2, PartsComposeToTheWhole) {
  for (const auto& a : examples())
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const double tolerance = 1e-12 * (1 + a.position().norm());
      expectSame(a.part(share) * a.part(1 - share), a, 2 * tolerance);
      EXPECT_NEAR(a.part(share).theta(), share * a.theta(), 1e-12);
    }
}

TEST(Pose2, TellsWhetherItIsFinite) {
  EXPECT_TRUE(Pose2(1, 2, 3).isFinite());
  EXPECT_FALSE(Pose2(std::nan(""), 0, 0).isFinite());
  EXPECT_FALSE(Pose2(0, INFINITY, 0).isFinite());
  EXPECT_FALSE(Pose2(0, 0, INFINITY).isFinite());
}

TEST(WrapAngle, StaysInTheHalfOpenInterval) {
  EXPECT_EQ(wrapAngle(M_PI), M_PI);
  EXPECT_EQ(wrapAngle(-M_PI), M_PI);
  EXPECT_EQ(wrapAngle(3 * M_PI), M_PI);
  EXPECT_EQ(wrapAngle(-3 * M_PI), M_PI);
  EXPECT_EQ(wrapAngle(std::nextafter(-M_PI, 0)), std::nextafter(-M_PI, 0));
  EXPECT_LT(wrapAngle(std::nextafter(M_PI, 4)), 0.0);
  EXPECT_EQ(wrapAngle(0.0), 0.0);
  RandomStream random(2, 0);
  for (int i = 0; i < 10000; ++i) {
    const double angle = 50 * random.gaussian(), wrapped = wrapAngle(angle);
    ASSERT_GT(wrapped, -M_PI);
    ASSERT_LE(wrapped, M_PI);
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), 1e-13);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), 1e-13);
  }
}

TEST(Pose2, AdjointTakesATwistToTheOtherSide) {
  const Eigen::Vector3d twist(0.3, -0.2, 0.4);
  for (const auto& a : examples())
    expectSame(a * Pose2::exp(twist), Pose2::exp(a.adjoint() * twist) * a, 1e-9);
}

TEST(Pose2, TwistJacobianIsThatOfItsCoordinates) {
  for (const auto& a : examples()) {
    const auto J = test::numericJacobian(
        [&](const Eigen::VectorXd& twist) -> Eigen::VectorXd {
          return (a * Pose2::exp(twist)).vector();
        },
        Eigen::VectorXd::Zero(3),
        [](const Eigen::VectorXd& x, const Eigen::VectorXd& y) -> Eigen::VectorXd {
          return difference(x, y);
        });
    EXPECT_TRUE(J.isApprox(a.twistJacobian(), 1e-6));
  }
}

}  // namespace
}  // namespace slam
