// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/dense_covariance.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/random.hpp"

namespace slam::ekf {
namespace {

Eigen::MatrixXd randomMatrix(RandomStream& random, Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.gaussian(); });
}

Eigen::MatrixXd randomCovariance(RandomStream& random, Eigen::Index size) {
  const auto A = randomMatrix(random, size, size + 2);
  return A * A.transpose();
}

std::vector<Innovation> randomInnovations(RandomStream& random, Eigen::Index landmarks) {
  std::vector<Innovation> innovations;
  for (Eigen::Index i = 0; i < landmarks; i += 1 + i % 3) {
    Innovation innovation;
    innovation.slot = (i * 7) % landmarks;  // in no order
    innovation.H_robot = randomMatrix(random, 2, 3);
    innovation.H_heading = randomMatrix(random, 2, 1);
    innovation.H_landmark = randomMatrix(random, 2, 2);
    innovations.push_back(innovation);
  }
  return innovations;
}

Eigen::MatrixXd fullJacobian(const std::vector<Innovation>& innovations, Eigen::Index size) {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2 * Eigen::Index(innovations.size()), size);
  for (std::size_t i = 0; i < innovations.size(); ++i) {
    H.block<2, 3>(2 * Eigen::Index(i), 0) = innovations[i].H_robot;
    H.block<2, 1>(2 * Eigen::Index(i), 5) = innovations[i].H_heading;
    H.block<2, 2>(2 * Eigen::Index(i), 6 + 2 * innovations[i].slot) = innovations[i].H_landmark;
  }
  return H;
}

/// The whole matrix, both triangles.
Eigen::MatrixXd jointOf(const DenseCovariance& P) {
  Eigen::MatrixXd joint(P.size(), P.size());
  for (Eigen::Index column = 0; column < P.size(); ++column)
    for (Eigen::Index row = 0; row < P.size(); ++row) joint(row, column) = P(row, column);
  return joint;
}

void expectSame(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-10 * (1 + b.cwiseAbs().maxCoeff()));
}

/// Against the same operations on full matrices, for maps below and above the blocks of the update.
class DenseCovarianceTest : public testing::TestWithParam<int> {
 protected:
  const Eigen::Index landmarks = GetParam(), size = 6 + 2 * landmarks;
  RandomStream random{1, std::uint64_t(GetParam())};
  Eigen::MatrixXd P = randomCovariance(random, size);
  DenseCovariance covariance{P};
};

TEST_P(DenseCovarianceTest, TellsItsBlocks) {
  expectSame(jointOf(covariance), P);
  EXPECT_EQ(jointOf(covariance), jointOf(covariance).transpose());
  expectSame(covariance.robot(), P.topLeftCorner<3, 3>());
  EXPECT_EQ(covariance(1, size - 1), covariance(size - 1, 1));
  EXPECT_NEAR(relativeHeadingVariance(covariance), P(2, 2) + P(5, 5) - 2 * P(2, 5), 1e-9);
  for (Eigen::Index i = 0; i < landmarks; ++i)
    expectSame(landmarkOf(covariance, i), P.block<2, 2>(6 + 2 * i, 6 + 2 * i));
}

TEST_P(DenseCovarianceTest, PredictsAsTheFullMatrixDoes) {
  const Eigen::Matrix3d F = randomMatrix(random, 3, 3), Q = randomCovariance(random, 3);
  covariance.predict(F, Q);
  Eigen::MatrixXd F_full = Eigen::MatrixXd::Identity(size, size);
  F_full.topLeftCorner<3, 3>() = F;
  Eigen::MatrixXd expected = F_full * P * F_full.transpose();
  expected.topLeftCorner<3, 3>() += Q;
  expectSame(jointOf(covariance), expected);
}

TEST_P(DenseCovarianceTest, CarriesTheRobotsErrorAlong) {
  const Eigen::Vector2d c(0.3, -0.7);
  transportRobot(c, covariance);
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(size, size);
  T.block<2, 1>(0, 2) = c;
  expectSame(jointOf(covariance), T * P * T.transpose());
}

TEST_P(DenseCovarianceTest, MultipliesWithTheSparseJacobian) {
  const auto innovations = randomInnovations(random, landmarks);
  expectSame(covariance.timesTransposed(innovations),
             P * fullJacobian(innovations, size).transpose());
}

TEST_P(DenseCovarianceTest, SubtractsAnOuterProductOfAnyWidth) {
  for (const Eigen::Index width : {1, 2, 3, 8, 17, 40}) {
    const auto W = randomMatrix(random, size, width);
    covariance.subtractOuterProduct(W);
    P -= W * W.transpose();
    expectSame(jointOf(covariance), P);
  }
}

TEST_P(DenseCovarianceTest, LeavesTheMapAloneWhenOnlyTheRobotIsUpdated) {
  const auto W = randomMatrix(random, size, 4);
  const Eigen::Index rest = size - 3;
  const Eigen::MatrixXd map_before = jointOf(covariance).bottomRightCorner(rest, rest);
  covariance.subtractOuterProductOfRobot(W);
  EXPECT_EQ(jointOf(covariance).bottomRightCorner(rest, rest), map_before);
  Eigen::MatrixXd expected = P - W * W.transpose();
  expected.bottomRightCorner(rest, rest) = map_before;
  expectSame(jointOf(covariance), expected);
}

TEST_P(DenseCovarianceTest, AppendsALandmarkWithItsCorrelations) {
  const DenseCovariance::Matrix23 J = randomMatrix(random, 2, 3);
  const Eigen::Matrix2d R = randomCovariance(random, 2);
  covariance.append(J, R);
  Eigen::MatrixXd J_full = Eigen::MatrixXd::Zero(size + 2, size);
  J_full.topRows(size).setIdentity();
  J_full.bottomLeftCorner<2, 3>() = J;
  Eigen::MatrixXd expected = J_full * P * J_full.transpose();
  expected.bottomRightCorner<2, 2>() += R;
  expectSame(jointOf(covariance), expected);
}

TEST_P(DenseCovarianceTest, AppendsALandmarkOfWhichEverythingIsKnown) {
  const Eigen::MatrixXd larger = randomCovariance(random, size + 2);
  DenseCovariance grown{Eigen::MatrixXd(larger.topLeftCorner(size, size))};
  grown.appendJoint(larger.bottomLeftCorner(2, size), larger.bottomRightCorner<2, 2>());
  expectSame(jointOf(grown), larger);
}

TEST(DenseCovarianceStart, HoldsTheRobotTwice) {
  RandomStream random(4, 0);
  const Eigen::Matrix3d robot = randomCovariance(random, 3);
  const DenseCovariance covariance{robot};
  expectSame(jointOf(covariance), robot.replicate<2, 2>());
  EXPECT_NEAR(relativeHeadingVariance(covariance), 0.0, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Landmarks, DenseCovarianceTest, testing::Values(1, 2, 5, 15, 16, 40, 101));

TEST(DenseCovarianceGrowth, KeepsEveryValueOverSeveralDoublings) {
  RandomStream random(5, 0);
  Eigen::MatrixXd P = randomCovariance(random, 6);
  DenseCovariance covariance{P};
  for (Eigen::Index i = 0; i < 150; ++i) {  // capacity 70, 140, 280, 560
    const DenseCovariance::Matrix23 J = 0.1 * randomMatrix(random, 2, 3);
    const Eigen::Matrix2d R = randomCovariance(random, 2);
    covariance.append(J, R);
    const Eigen::MatrixXd cross = J * P.topRows<3>();
    P.conservativeResize(P.rows() + 2, P.cols() + 2);
    P.bottomLeftCorner(2, P.cols() - 2) = cross;
    P.topRightCorner(P.rows() - 2, 2) = cross.transpose();
    P.bottomRightCorner<2, 2>() = J * P.topLeftCorner<3, 3>() * J.transpose() + R;
    const Eigen::MatrixXd W = 0.05 * randomMatrix(random, P.rows(), 2);
    covariance.subtractOuterProduct(W);
    P -= W * W.transpose();
  }
  EXPECT_EQ(covariance.size(), 306);
  expectSame(jointOf(covariance), P);
}

}  // namespace
}  // namespace slam::ekf
