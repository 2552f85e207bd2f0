// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <memory>
#include <vector>

#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam::graph {
namespace {

Eigen::Matrix3d someWeight() {
  return (Eigen::Matrix3d() << 10, 2, -1, 0, 5, 3, 0, 0, 20).finished();
}

template <class Value>
Key addTo(Variables& variables, const Value& value) {
  const auto key = static_cast<Key>(variables.size());
  variables.put(key, value);
  return key;
}

/// Two poses and a point, and one factor of each kind, none of them satisfied.
struct Example {
  Example() {
    const Key a = addTo(variables, Pose2(1, 2, 0.7)), b = addTo(variables, Pose2(-0.5, 3, 2.9));
    const Key m = addTo(variables, Eigen::Vector2d(4, 1));
    factors.push_back(std::make_unique<PosePrior>(a, Pose2(1.1, 1.8, 0.4), someWeight()));
    factors.push_back(std::make_unique<PointPrior>(m, Eigen::Vector2d(4.2, 0.9),
                                                   someWeight().topLeftCorner<2, 2>()));
    factors.push_back(std::make_unique<Between>(a, b, Pose2(-0.3, 2, 2.5), someWeight()));
    factors.push_back(std::make_unique<Between>(b, a, Pose2(0.3, -1, -1.5), someWeight()));
    factors.push_back(std::make_unique<RangeBearing>(
        b, m, Pose2(0.2, 0.1, 0.3), Eigen::Vector2d(4.5, 2.0), someWeight().topLeftCorner<2, 2>()));
    const Eigen::MatrixXd W = Eigen::MatrixXd::Random(5, 5);
    factors.push_back(std::make_unique<JointPrior>(std::vector<Key>{b, m}, Pose2(-0.6, 3.2, 2.7),
                                                   std::vector<Eigen::Vector2d>{{4.1, 1.3}}, W));
  }
  Variables variables;
  std::vector<std::unique_ptr<Factor>> factors;
};

LinearFactor linearized(const Factor& factor, const Variables& variables) {
  std::vector<Pose2> at;
  for (const Key key : factor.keys()) at.push_back(variables.pose(key));
  return factor.linearized(at);
}

/// The residual after corrections of the factor's variables.
Eigen::VectorXd residual(const Factor& factor, Variables variables, const Eigen::VectorXd& delta) {
  Eigen::Index row = 0;
  for (const Key key : factor.keys()) {
    variables.set(key, variables.corrected(key, delta.segment(row, variables.rows(key))));
    row += variables.rows(key);
  }
  return linearized(factor, variables).r;
}

TEST(Factors, HaveTheJacobiansOfTheirResiduals) {
  const Example example;
  for (const auto& factor : example.factors) {
    const auto linear = linearized(*factor, example.variables);
    const auto J = test::numericJacobian(
        [&](const Eigen::VectorXd& delta) { return residual(*factor, example.variables, delta); },
        Eigen::VectorXd::Zero(linear.J.cols()),
        [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) -> Eigen::VectorXd {
          return a - b;
        });
    EXPECT_TRUE(J.isApprox(linear.J, 1e-6)) << J << "\n\n" << linear.J;
  }
}

TEST(Factors, HaveNoResidualWhereTheyAreSatisfied) {
  Variables variables;
  const Pose2 a(1, 2, 3), a_b(0.5, -0.2, 0.3);
  const Key first = addTo(variables, a), second = addTo(variables, a * a_b);
  EXPECT_LT(linearized(Between(first, second, a_b, someWeight()), variables).r.norm(), 1e-12);
  EXPECT_LT(linearized(PosePrior(first, a, someWeight()), variables).r.norm(), 1e-12);
}

/// So a rigid motion of a part of the graph leaves its Jacobians as they are.
TEST(Factors, OfTwoPosesDoNotDependOnWhereThePosesAre) {
  Variables here, there;
  const Pose2 a(1, 2, 3), a_b(0.5, -0.2, 0.3), motion(10, -5, 2);
  addTo(here, a);
  addTo(here, a * a_b);
  addTo(there, motion * a);
  addTo(there, motion * a * a_b);
  const Between between(0, 1, Pose2(0.6, -0.1, 0.2), someWeight());
  EXPECT_TRUE(linearized(between, here).J.isApprox(linearized(between, there).J, 1e-12));
}

TEST(Weights, AreSquareRootsOfInformation) {
  const Eigen::Matrix3d information = someWeight().transpose() * someWeight();
  const auto W = weightOfInformation(information);
  EXPECT_TRUE((W.transpose() * W).isApprox(information, 1e-12));
  const auto V = weightOfCovariance(information.inverse());
  EXPECT_TRUE((V.transpose() * V).isApprox(information, 1e-9));
}

/// No sensor is surer, and what is a million times surer would erase all else by rounding.
TEST(Weights, AreOfAtLeastAMicrometre) {
  const auto W = weightOfCovariance(Eigen::Vector2d(1e-300, 1e-4).asDiagonal());
  EXPECT_NEAR(W(0, 0), 1e6, 1.0);
  EXPECT_NEAR(W(1, 1), 1e2, 1e-2);
}

TEST(Weights, TakeACovarianceThatRoundingHasMadeIndefinite) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 2) / 3;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  const auto W = weightOfCovariance(100.0 * across - 1e-10 * axis * axis.transpose());
  EXPECT_NEAR((W * axis).norm(), 1e6, 1e4);
  const Eigen::Vector3d other = Eigen::Vector3d(2, 1, -2) / 3;  // across the axis
  EXPECT_NEAR((W * other).norm(), 0.1, 1e-2);
}

}  // namespace
}  // namespace slam::graph
