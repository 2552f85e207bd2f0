// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/maximum_likelihood.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"

namespace slam::tuning {
namespace {

/// log N(z; 0, variance)
double normal(double z, double variance) { return -0.5 * (z * z / variance + std::log(variance)); }

TEST(MaximumLikelihood, FindsVariancesAndHowSureTheyAre) {
  constexpr int kDraws = 2000;
  RandomStream random(1, 0);
  Eigen::VectorXd one(kDraws), both(kDraws);  // of variances 4 and 4 + 4
  for (int i = 0; i < kDraws; ++i) {
    one(i) = 2.0 * random.gaussian();
    both(i) = std::sqrt(8.0) * random.gaussian();
  }
  const auto maximum = maximize(
      [&](const Eigen::VectorXd& x) {
        Eigen::VectorXd values(kDraws);
        for (int i = 0; i < kDraws; ++i)
          values(i) =
              normal(one(i), std::exp(x(0))) + normal(both(i), std::exp(x(0)) + std::exp(x(1)));
        return values;
      },
      Eigen::Vector2d(-2.0, 3.0));
  EXPECT_TRUE(maximum.has_converged);
  Eigen::Matrix2d information;  // of one draw: half of the product of the shares of the variance
  information << 0.5 + 0.125, 0.125, 0.125, 0.125;
  const Eigen::Vector2d sigma = (kDraws * information).inverse().diagonal().cwiseSqrt();
  const Eigen::Vector2d found = maximum.sigmas;
  EXPECT_NEAR(maximum.log_parameters(0), std::log(4.0), 3 * sigma(0));
  EXPECT_NEAR(maximum.log_parameters(1), std::log(4.0), 3 * sigma(1));
  EXPECT_NEAR(found(0), sigma(0), 0.2 * sigma(0));
  EXPECT_NEAR(found(1), sigma(1), 0.2 * sigma(1));
  EXPECT_LT(conditionalSigmas(maximum.information)(1), found(1));
}

TEST(MaximumLikelihood, DoesNotLeaveWhereTheLikelihoodIsDefined) {
  const auto f = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd::Constant(1, x(0) > 2 ? std::nan("") : -std::pow(x(0) - 1.9, 2));
  };
  EXPECT_NEAR(maximize(f, Eigen::VectorXd::Zero(1)).log_parameters(0), 1.9, 0.1);
}

TEST(MaximumLikelihood, SaysThatNothingIsKnownOfWhatDoesNotMatter) {
  const auto f = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd::Constant(1, normal(1.0, std::exp(x(0))));
  };
  const auto maximum = maximize(f, Eigen::Vector2d(0.5, 0.7));
  EXPECT_EQ(maximum.log_parameters(1), 0.7);
  EXPECT_GT(conditionalSigmas(maximum.information)(1), 1.0);
  EXPECT_GT(maximum.sigmas(1), 1.0);
}

/// Noise of variance 1 that is seldom small and often far out, and alike in a row of steps.
Eigen::VectorXd unkindNoise(std::uint64_t seed, int count) {
  RandomStream random(seed, 0);
  Eigen::VectorXd noise(count);
  double strength = 1.0;
  for (int i = 0; i < count; ++i) {
    if (i % 5 == 0) strength = random.uniform() < 0.2 ? 2.0 : 0.5;
    noise(i) = strength * random.gaussian();
  }
  return noise;
}

TEST(MaximumLikelihood, TellsAnUncertaintyThatHoldsWhereTheModelDoesNot) {
  constexpr int kRuns = 200, kSteps = 1500;
  double sum = 0.0;
  int inside = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto noise = unkindNoise(static_cast<std::uint64_t>(run), kSteps);
    const auto maximum = maximize(
        [&](const Eigen::VectorXd& x) {
          return noise.unaryExpr([&](double z) { return normal(z, std::exp(x(0))); }).eval();
        },
        Eigen::VectorXd::Constant(1, 0.5));
    const double off = maximum.log_parameters(0) / maximum.sigmas(0);
    sum += off * off;
    inside += std::abs(off) < 2.0;
  }
  EXPECT_NEAR(std::sqrt(sum / kRuns), 1.0, 0.2);
  EXPECT_GT(inside, 0.9 * kRuns);
}

}  // namespace
}  // namespace slam::tuning
