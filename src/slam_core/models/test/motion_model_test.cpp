// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam {
namespace {

const OdometryNoise kNoise{0.01, 0.002, 0.003, 0.02};

OdometryNoise omnidirectional(OdometryNoise noise) {
  noise.omnidirectional = true;
  return noise;
}

/// The covariance of `increment` driven in `parts` equal pieces.
Eigen::Matrix3d composed(const MotionModel& model, const Pose2& increment, int parts) {
  const Pose2 piece = increment.part(1.0 / parts);
  const Eigen::Matrix3d Q_piece = model.covariance(piece);
  Pose2 pose;
  Eigen::Matrix3d P = Eigen::Matrix3d::Zero(), F, G;
  for (int i = 0; i < parts; ++i) {
    pose = pose.compose(piece, &F, &G);
    P = F * P * F.transpose() + G * Q_piece * G.transpose();
  }
  return P;
}

/// What every motion model promises.
class MotionModelContract : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<MotionModel> make(const OdometryNoise& noise) const {
    return makeMotionModel(GetParam(), noise);
  }
};

TEST_P(MotionModelContract, IsSymmetricAndPositiveSemidefinite) {
  RandomStream random(1, 0);
  for (const auto& noise : {kNoise, omnidirectional(kNoise)})
    for (int i = 0; i < 500; ++i) {
      const double size = std::pow(10.0, -6 * random.uniform());
      const Pose2 increment(size * random.gaussian(), size * random.gaussian(),
                            size * random.gaussian());
      const auto Q = make(noise)->covariance(increment);
      ASSERT_TRUE(Q.allFinite());
      ASSERT_LT((Q - Q.transpose()).norm(), 1e-12 * Q.norm());
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Q);
      ASSERT_GT(eigen.eigenvalues().minCoeff(), -1e-12 * Q.norm());
    }
}

TEST_P(MotionModelContract, IsCertainOfStandingStill) {
  EXPECT_TRUE(make(kNoise)->covariance(Pose2()).isZero(0.0));
}

TEST_P(MotionModelContract, GrowsWithEveryAlpha) {
  const Pose2 increment(1.0, 0.2, 0.5);
  const double before = make(kNoise)->covariance(increment).trace();
  for (double OdometryNoise::*alpha : {&OdometryNoise::alpha1, &OdometryNoise::alpha2,
                                       &OdometryNoise::alpha3, &OdometryNoise::alpha4}) {
    OdometryNoise more = kNoise;
    more.*alpha *= 2;
    EXPECT_GT(make(more)->covariance(increment).trace(), before);
  }
}

TEST_P(MotionModelContract, GivesTheSameBackwardsAndMirrored) {
  const auto model = make(kNoise);
  const auto Q = model->covariance(Pose2(1, 0, 0));
  EXPECT_TRUE(model->covariance(Pose2(-1, 0, 0)).diagonal().isApprox(Q.diagonal(), 1e-12));
  const Eigen::Vector3d mirror(1, -1, -1);
  const auto left = model->covariance(Pose2(1, 0.3, 0.4));
  const auto right = model->covariance(Pose2(1, -0.3, -0.4));
  EXPECT_TRUE(right.isApprox(mirror.asDiagonal() * left * mirror.asDiagonal(), 1e-12));
}

TEST_P(MotionModelContract, LetsOnlyAnOmnidirectionalBaseSlipSideways) {
  OdometryNoise slip{0.01, 0, 0, 0};
  const Pose2 ahead(2, 0, 0);
  EXPECT_EQ(make(slip)->covariance(ahead)(1, 1), 0.0);
  const auto Q = make(omnidirectional(slip))->covariance(ahead);
  EXPECT_NEAR(Q(1, 1), Q(0, 0), 1e-15);
  EXPECT_GT(Q(1, 1), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, MotionModelContract, testing::ValuesIn(motionModelNames()),
                         [](const auto& name) { return name.param; });

TEST(QuadraticMotionModel, IsEquation52OnAStraightLine) {
  // d = 2, r = 0: translation variance 0.01 * 4, rotation variance 0.003 * 4, which moves the end
  // sideways by 2 m a radian (Eq. 5.1)
  Eigen::Matrix3d expected;
  expected << 0.04, 0, 0, 0, 0.048, 0.024, 0, 0.024, 0.012;
  EXPECT_TRUE(QuadraticMotionModel(kNoise).covariance(Pose2(2, 0, 0)).isApprox(expected, 1e-12));
}

TEST(QuadraticMotionModel, IsEquation52WithATurn) {
  // d = 5 towards (0.6, 0.8), r = 0.5: translation 0.01 * 25 + 0.002 * 0.25 = 0.2505,
  // rotation 0.003 * 25 + 0.02 * 0.25 = 0.08
  const Eigen::Vector3d J_translation(0.6, 0.8, 0), J_rotation(-4, 3, 1);
  const Eigen::Matrix3d expected = 0.2505 * J_translation * J_translation.transpose() +
                                   0.08 * J_rotation * J_rotation.transpose();
  EXPECT_TRUE(QuadraticMotionModel(kNoise).covariance(Pose2(3, 4, 0.5)).isApprox(expected, 1e-12));
}

TEST(QuadraticMotionModel, DependsOnTheRateOfOdometry) {
  const QuadraticMotionModel model(kNoise);
  const Pose2 way(1, 0, 0);
  EXPECT_LT(composed(model, way, 10).trace(), 0.2 * model.covariance(way).trace());
}

TEST(LinearMotionModel, DoesNotDependOnTheRateOfOdometry) {
  for (const auto& noise : {kNoise, omnidirectional(kNoise)}) {
    const LinearMotionModel model(noise);
    for (const auto& way : {Pose2(1, 0, 0), Pose2(0, 0, 1), Pose2(1, 0.1, 0.3), Pose2(-2, 1, -0.8)})
      for (const int parts : {2, 7, 50}) {
        const auto Q = model.covariance(way);
        EXPECT_LT((composed(model, way, parts) - Q).norm(), 0.01 * Q.norm())
            << parts << " parts of " << way.vector().transpose();
      }
  }
}

TEST(LinearMotionModel, IsTheSpreadOfNoiseThatEntersAlongTheArc) {
  const LinearMotionModel model(kNoise);
  const Eigen::Vector3d twist(1.5, 0, 0.9);
  const Pose2 way = Pose2::exp(twist);
  constexpr int kRuns = 20000, kPieces = 30;
  const double translation = std::sqrt((kNoise.alpha1 * 1.5 + kNoise.alpha2 * 0.9) / kPieces);
  const double rotation = std::sqrt((kNoise.alpha3 * 1.5 + kNoise.alpha4 * 0.9) / kPieces);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    RandomStream random(9, run);
    Pose2 pose;
    for (int i = 0; i < kPieces; ++i) {
      const Eigen::Vector3d noise(translation * random.gaussian(), 0, rotation * random.gaussian());
      pose = pose * Pose2::exp(twist / kPieces + noise);
    }
    const Eigen::Vector3d error = pose.vector() - way.vector();
    spread += error * error.transpose() / kRuns;
  }
  const auto Q = model.covariance(way);
  EXPECT_LT((spread - Q).norm(), 0.04 * Q.norm()) << spread << "\nand\n" << Q;
}

OdometryNoise velocityNoise() {
  OdometryNoise noise = kNoise;
  noise.alpha5 = 0.004;
  noise.alpha6 = 0.006;
  return noise;
}

TEST(VelocityMotionModel, IsTheSpreadOfTable53) {
  const OdometryNoise noise = velocityNoise();
  constexpr double kSpeed = 1.5, kTurnRate = 0.6, kInterval = 0.8;  // [m/s, rad/s, s]
  constexpr double v2 = kSpeed * kSpeed, w2 = kTurnRate * kTurnRate;
  constexpr int kRuns = 40000;
  const double speed_sigma = std::sqrt(noise.alpha1 * v2 + noise.alpha2 * w2);
  const double turn_sigma = std::sqrt(noise.alpha3 * v2 + noise.alpha4 * w2);
  const double final_sigma = std::sqrt(noise.alpha5 * v2 + noise.alpha6 * w2);
  const Eigen::Vector3d way =
      Pose2::exp(kInterval * Eigen::Vector3d(kSpeed, 0, kTurnRate)).vector();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    RandomStream random(11, run);
    const double v = kSpeed + speed_sigma * random.gaussian();
    const double w = kTurnRate + turn_sigma * random.gaussian();
    const double gamma = final_sigma * random.gaussian();
    const Eigen::Vector3d end(v / w * std::sin(w * kInterval),
                              v / w * (1.0 - std::cos(w * kInterval)), (w + gamma) * kInterval);
    spread += (end - way) * (end - way).transpose() / kRuns;
  }
  const auto Q = VelocityMotionModel(noise).covariance(Pose2::fromVector(way));
  EXPECT_LT((spread - Q).norm(), 0.03 * Q.norm()) << spread << "\nand\n" << Q;
}

TEST(VelocityMotionModel, PropagatesItsNoiseByTheDerivativeOfTheArc) {
  const auto noise = velocityNoise();
  for (const Eigen::Vector3d& twist :
       {Eigen::Vector3d(1.0, 0, 0), Eigen::Vector3d(-0.5, 0, 0.7), Eigen::Vector3d(2, 0, 1e-5)}) {
    const auto arc = [](const Eigen::VectorXd& u) -> Eigen::VectorXd {
      return Pose2::exp(Eigen::Vector3d(u(0), 0.0, u(1))).vector();
    };
    const auto minus = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) -> Eigen::VectorXd {
      return a - b;
    };
    const Eigen::MatrixXd J =
        test::numericJacobian(arc, Eigen::Vector2d(twist.x(), twist.z()), minus);
    const double d2 = twist.x() * twist.x(), r2 = twist.z() * twist.z();
    const Eigen::Vector2d M(noise.alpha1 * d2 + noise.alpha2 * r2,
                            noise.alpha3 * d2 + noise.alpha4 * r2);
    Eigen::Matrix3d expected = J * M.asDiagonal() * J.transpose();
    expected(2, 2) += noise.alpha5 * d2 + noise.alpha6 * r2;
    const auto Q = VelocityMotionModel(noise).covariance(Pose2::exp(twist));
    EXPECT_LT((Q - expected).norm(), 1e-7 * expected.norm()) << twist.transpose();
  }
}

TEST(VelocityMotionModel, ItsFinalRotationGivesItFullRankWhereverItDrives) {
  for (const auto& way : {Pose2(1, 0, 0), Pose2(0.7, 0.1, 0.3), Pose2(-2, 0.4, -0.5)}) {
    const auto rank = [&](const OdometryNoise& noise) {
      const Eigen::Matrix3d Q = VelocityMotionModel(noise).covariance(way);
      const auto sigmas2 = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(Q).eigenvalues().eval();
      return (sigmas2.array() > 1e-9 * sigmas2.maxCoeff()).count();
    };
    EXPECT_EQ(rank(kNoise), 2) << "an arc alone has two degrees of freedom";
    EXPECT_EQ(rank(velocityNoise()), 3);
  }
}

}  // namespace
}  // namespace slam
