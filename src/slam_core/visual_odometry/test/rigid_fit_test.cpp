// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/rigid_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "slam_core/visual_odometry/alignment.hpp"
#include "slam_core/visual_odometry/consensus.hpp"

namespace slam::visual_odometry {
namespace {

const Similarity kMotion{1.0, Pose2(0.3, -0.2, 0.4)};

/// Matches of points in a square of 2 m, with noise of their sigma.
PointMatches matchesOf(const Similarity& motion, int count, double sigma, RandomStream& random) {
  PointMatches matches;
  for (int i = 0; i < count; ++i) {
    PointMatch match;
    match.now = {2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0};
    match.reference = motion.scale * (motion.T_reference_now.rotation() * match.now) +
                      motion.T_reference_now.position() +
                      sigma * Eigen::Vector2d(random.gaussian(), random.gaussian());
    match.sigma = sigma > 0.0 ? sigma : 0.001;
    matches.push_back(match);
  }
  return matches;
}

void addOutliers(PointMatches& matches, int count, RandomStream& random) {
  for (int i = 0; i < count; ++i) {
    PointMatch match = matches.front();
    match.now = {2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0};
    match.reference = {2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0};
    matches.push_back(match);
  }
}

TEST(RigidFit, IsExactWithoutNoise) {
  RandomStream random(1, 0);
  const Similarity motion{1.3, kMotion.T_reference_now};
  const auto fit = fitSimilarity(matchesOf(motion, 2, 0.0, random));
  EXPECT_NEAR(fit.scale, 1.3, 1e-12);
  EXPECT_TRUE(fit.T_reference_now.vector().isApprox(motion.T_reference_now.vector(), 1e-12));
  const auto rigid = fitRigid(matchesOf(kMotion, 3, 0.0, random));
  EXPECT_TRUE(rigid.vector().isApprox(kMotion.T_reference_now.vector(), 1e-12));
}

TEST(RigidFit, CovarianceIsThatOfManyFits) {
  RandomStream random(2, 0);
  constexpr int kTrials = 2000;
  double sum = 0.0, residual = 0.0;
  for (int i = 0; i < kTrials; ++i) {
    const auto matches = matchesOf(kMotion, 20, 0.01, random);
    const auto fit = fitRigid(matches);
    const Eigen::Vector3d error = fit.vector() - kMotion.T_reference_now.vector();
    sum += error.dot(rigidCovariance(matches, fit).inverse() * error) / 3.0;
    residual += residualSigma(matches, fit);
  }
  EXPECT_NEAR(sum / kTrials, 1.0, 0.06);
  EXPECT_NEAR(residual / kTrials, 1.0, 0.02);
}

TEST(Consensus, FindsTheMotionOfAThirdOfTheMatches) {
  RandomStream random(3, 0);
  for (std::uint64_t trial = 0; trial < 50; ++trial) {
    auto matches = matchesOf(kMotion, 40, 0.002, random);
    addOutliers(matches, 80, random);
    RandomStream draws(1, trial);
    const auto found = findConsensus(matches, 3.0, draws);
    ASSERT_TRUE(found);
    EXPECT_GE(found->size(), 35u);
    EXPECT_NEAR(fitRigid(*found).theta(), 0.4, 0.01);
  }
}

TEST(Consensus, IsTheSameForTheSameDraws) {
  RandomStream random(4, 0);
  auto matches = matchesOf(kMotion, 30, 0.005, random);
  addOutliers(matches, 60, random);
  RandomStream first(1, 5), again(1, 5);
  const auto a = findConsensus(matches, 2.0, first), b = findConsensus(matches, 2.0, again);
  ASSERT_EQ(a->size(), b->size());
  for (std::size_t i = 0; i < a->size(); ++i) EXPECT_EQ((*a)[i].now, (*b)[i].now);
}

TEST(Consensus, HasNothingToSayOfOneMatchOrOfOnePoint) {
  RandomStream random(5, 0);
  auto matches = matchesOf(kMotion, 1, 0.0, random);
  EXPECT_FALSE(findConsensus(matches, 1.0, random));
  matches.resize(20, matches.front());
  EXPECT_FALSE(findConsensus(matches, 1.0, random));
}

TEST(Alignment, RefusesAnotherScaleAndTooFewInliers) {
  RandomStream random(6, 0);
  const VisualOdometryConfig config;
  EXPECT_EQ(align(matchesOf(kMotion, 40, 0.002, random), config, random).fault, "");
  const auto nearer =
      align(matchesOf({1.1, kMotion.T_reference_now}, 40, 0.002, random), config, random);
  EXPECT_EQ(nearer.fault, "scale");
  EXPECT_NEAR(nearer.scale, 1.1, 0.01);
  EXPECT_EQ(align(matchesOf(kMotion, 14, 0.002, random), config, random).fault, "few_inliers");
  EXPECT_EQ(align({}, config, random).fault, "few_inliers");
}

}  // namespace
}  // namespace slam::visual_odometry
