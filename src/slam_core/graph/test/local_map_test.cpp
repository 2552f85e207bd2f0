// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/local_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "slam_core/common/random.hpp"
#include "slam_core/graph/variables.hpp"

namespace slam::graph {
namespace {

constexpr double kStep = 1e-6;

Eigen::MatrixXd randomCovariance(Eigen::Index size, RandomStream& random) {
  Eigen::MatrixXd A(size, size);
  for (auto& each : A.reshaped()) each = 0.1 * random.gaussian();
  return A * A.transpose() + 1e-2 * Eigen::MatrixXd::Identity(size, size);
}

LocalMap randomMap(std::size_t poses, std::size_t points, RandomStream& random) {
  LocalMap map;
  for (std::size_t i = 0; i < poses; ++i)
    map.poses.emplace_back(random.gaussian(), random.gaussian(), random.gaussian());
  for (std::size_t i = 0; i < points; ++i)
    map.points.emplace_back(5.0 * random.gaussian(), 5.0 * random.gaussian());
  map.covariance = randomCovariance(static_cast<Eigen::Index>(3 * poses + 2 * points), random);
  return map;
}

/// Where poses and points of a local map lie, and a little off.
std::vector<Pose2> placed(const LocalMap& map, const Pose2& base, RandomStream& random) {
  std::vector<Pose2> at;
  for (const auto& pose : map.poses)
    at.push_back(base * pose * Pose2::exp(0.05 * Eigen::Vector3d(1, -1, 1) * random.gaussian()));
  for (const auto& point : map.points) {
    const auto p = base.transform(point);
    at.emplace_back(p.x() + 0.05 * random.gaussian(), p.y() + 0.05 * random.gaussian(), 0.0);
  }
  return at;
}

Pose2 corrected(const Pose2& value, bool is_pose, int axis, double by) {
  Variables variables;
  const Eigen::VectorXd delta = by * Eigen::VectorXd::Unit(is_pose ? 3 : 2, axis);
  if (is_pose)
    variables.put(0, value);
  else
    variables.put(0, Eigen::Vector2d(value.position()));
  return variables.corrected(0, delta);
}

/// @param poses how many of `at` are poses
Eigen::MatrixXd numericJacobian(const Factor& factor, const std::vector<Pose2>& at,
                                std::size_t poses) {
  std::vector<Eigen::VectorXd> columns;
  for (std::size_t i = 0; i < at.size(); ++i)
    for (int axis = 0; axis < (i < poses ? 3 : 2); ++axis) {
      auto more = at, less = at;
      more[i] = corrected(at[i], i < poses, axis, kStep);
      less[i] = corrected(at[i], i < poses, axis, -kStep);
      columns.push_back((factor.linearized(more).r - factor.linearized(less).r) / (2.0 * kStep));
    }
  Eigen::MatrixXd J(columns[0].size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) J.col(static_cast<Eigen::Index>(i)) = columns[i];
  return J;
}

std::vector<Key> keys(std::size_t count) { return std::vector<Key>(count, 0); }

TEST(LocalMap, HasTheJacobianOfItsResidual) {
  RandomStream random(1, 0);
  const auto map = randomMap(2, 3, random);
  const Pose2 base(1, 2, 0.7);
  auto at = placed(map, base, random);
  at.insert(at.begin(), base);
  const BasedMap factor(keys(at.size()), map);
  // a pose's error is zero to first order in the Jacobian that takes twists to coordinates
  EXPECT_TRUE(factor.linearized(at).J.isApprox(numericJacobian(factor, at, 3), 1e-2));
}

TEST(LocalMap, HasNoResidualWhereEverythingLiesAsItSays) {
  RandomStream random(2, 0);
  const auto map = randomMap(1, 4, random);
  const Pose2 base(-3, 5, 2.0);
  std::vector<Pose2> at = {base * map.poses[0]};
  for (const auto& point : map.points) {
    const auto p = base.transform(point);
    at.emplace_back(p.x(), p.y(), 0.0);
  }
  const FreeMap factor(keys(at.size()), map);
  EXPECT_LT(factor.linearized(at).r.norm(), 1e-9);
  EXPECT_LT((factor.base(at).vector() - base.vector()).norm(), 1e-9);
}

/// What is left of the base is what elimination leaves of it.
TEST(LocalMap, WithoutItsBaseIsTheMarginalOfTheSameMap) {
  RandomStream random(3, 0);
  const auto map = randomMap(1, 4, random);
  const auto others = placed(map, Pose2(4, -1, 1.0), random);
  const FreeMap free(keys(others.size()), map);
  auto at = others;
  at.insert(at.begin(), free.base(others));
  const auto based = BasedMap(keys(at.size()), map).linearized(at);
  const Eigen::MatrixXd H = based.J.transpose() * based.J;
  const auto size = H.rows() - 3;
  const Eigen::MatrixXd marginal =
      H.bottomRightCorner(size, size) -
      H.bottomLeftCorner(size, 3) * H.topLeftCorner<3, 3>().inverse() * H.topRightCorner(3, size);
  const auto linear = free.linearized(others);
  EXPECT_TRUE((linear.J.transpose() * linear.J).isApprox(marginal, 1e-8));
}

TEST(LocalMap, SaysNothingOfWhereItLiesInTheMap) {
  RandomStream random(4, 0);
  const auto map = randomMap(0, 5, random);
  const auto at = placed(map, Pose2(), random);
  std::vector<Pose2> moved;
  const Pose2 motion(10, -20, 2.5);
  for (const auto& point : at) {
    const auto p = motion.transform(point.position());
    moved.emplace_back(p.x(), p.y(), 0.0);
  }
  const FreeMap factor(keys(at.size()), map);
  EXPECT_NEAR(factor.linearized(at).r.norm(), factor.linearized(moved).r.norm(), 1e-9);
  const auto J = factor.linearized(moved).J;
  const Eigen::MatrixXd H = J.transpose() * J;
  EXPECT_EQ(Eigen::FullPivLU<Eigen::MatrixXd>(H).setThreshold(1e-9).rank(), 7) << "10 less 3";
}

TEST(LocalMap, KeepsTheCovarianceOfThePointsThatStay) {
  RandomStream random(5, 0);
  const auto map = randomMap(1, 3, random);
  const auto part = marginal(map, {true, false, true});
  ASSERT_EQ(part.points.size(), 2u);
  EXPECT_EQ(part.points[1], map.points[2]);
  EXPECT_EQ(part.covariance.rows(), 7);
  EXPECT_EQ(part.covariance(6, 0), map.covariance(8, 0));
}

TEST(FreeMap, IsLinearizedWhereItsPointsHaveMovedTogether) {
  RandomStream random(7, 0);
  const auto map = randomMap(0, 4, random);
  const auto then = placed(map, Pose2(1, 2, 0.5), random);
  const FreeMap factor(keys(then.size()), map);
  std::vector<Pose2> now;
  for (const auto& point : then) now.emplace_back(point.x() + 30.0, point.y() - 20.0, 0.0);
  EXPECT_LT(factor.moved(then, now), 1e-9);
  const auto before = factor.linearized(then), after = factor.linearized(now);
  EXPECT_LT((before.J - after.J).norm(), 1e-6 * before.J.norm());
  EXPECT_LT((before.r - after.r).norm(), 1e-6 * (1.0 + before.r.norm()));
}

TEST(FreeMap, SaysByWhichAngleItsPointsHaveTurned) {
  LocalMap map;
  map.points = {{-10, 0}, {10, 0}, {0, 3}, {0, -3}};
  map.covariance = Eigen::MatrixXd::Identity(8, 8);
  const FreeMap factor(keys(map.points.size()), map);
  std::vector<Pose2> then, turned, apart;
  for (const auto& point : map.points) {
    const auto there = Pose2(50, 7, 0.1).transform(point);
    then.emplace_back(point.x(), point.y(), 0.0);
    turned.emplace_back(there.x(), there.y(), 0.0);
    apart.emplace_back(1.1 * point.x(), 1.1 * point.y(), 0.0);
  }
  EXPECT_NEAR(factor.moved(then, turned), 0.1, 1e-3);
  EXPECT_NEAR(factor.moved(then, apart), 0.1, 1e-9) << "a share of the radius";
}

TEST(FreeMap, CountsMetresWhereItIsTinyOrHuge) {
  for (const auto& [radius, expected] :
       {std::pair(0.0, 0.01), std::pair(0.1, 0.01), std::pair(300.0, 0.01 / 30.0)}) {
    LocalMap map;
    map.points = {{-radius, 0}, {radius, 0}};
    map.covariance = Eigen::MatrixXd::Identity(4, 4);
    const std::vector<Pose2> then = {{-radius, 0, 0}, {radius, 0, 0}};
    const std::vector<Pose2> now = {{-radius, 0.01, 0}, {radius, -0.01, 0}};
    EXPECT_NEAR(FreeMap(keys(2), map).moved(then, now), expected, 1e-9) << radius;
  }
}

}  // namespace
}  // namespace slam::graph
