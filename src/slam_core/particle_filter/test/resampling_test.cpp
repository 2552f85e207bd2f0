// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/resampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "slam_core/particle_filter/particles/hilbert_order.hpp"
#include "slam_core/particle_filter/particles/kld_size.hpp"
#include "slam_core/particle_filter/particles/weights.hpp"

namespace slam::particle_filter {
namespace {

const std::vector<double> kWeights = {0.05, 0.31, 0.0, 0.24, 0.18, 0.12, 0.1, 0.0};
constexpr std::size_t kCount = 20;
constexpr int kTrials = 20000;

struct Offspring {
  std::vector<double> mean, variance;
};

Offspring offspringOf(const std::string& name) {
  const auto resampling = makeResampling(name);
  Offspring offspring{std::vector<double>(kWeights.size(), 0.0), {}};
  std::vector<double> squares(kWeights.size(), 0.0);
  for (int trial = 0; trial < kTrials; ++trial) {
    RandomStream random(11, std::uint64_t(trial));
    std::vector<double> counts(kWeights.size(), 0.0);
    for (const auto i : resampling->draw(kWeights, kCount, random)) counts[i] += 1;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      offspring.mean[i] += counts[i] / kTrials;
      squares[i] += counts[i] * counts[i] / kTrials;
    }
  }
  for (std::size_t i = 0; i < squares.size(); ++i)
    offspring.variance.push_back(squares[i] - offspring.mean[i] * offspring.mean[i]);
  return offspring;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

class ResamplingPolicy : public testing::TestWithParam<std::string> {};

TEST_P(ResamplingPolicy, GivesEachParticleAsManyOffspringAsItsWeightSaysOnAverage) {
  const auto offspring = offspringOf(GetParam());
  for (std::size_t i = 0; i < kWeights.size(); ++i) {
    const double expected = kCount * kWeights[i];
    const double sigma = std::sqrt(expected * (1 - kWeights[i]) / kTrials);  // multinomial: largest
    EXPECT_NEAR(offspring.mean[i], expected, 4 * sigma + 1e-12) << i;
  }
}

TEST_P(ResamplingPolicy, DrawsSoManyInAscendingOrder) {
  const auto resampling = makeResampling(GetParam());
  for (const std::size_t count : {1, 7, 8, 1000}) {
    RandomStream random(1, count);
    const auto drawn = resampling->draw(kWeights, count, random);
    EXPECT_EQ(drawn.size(), count);
    EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
    for (const auto i : drawn) EXPECT_GT(kWeights[i], 0.0);
  }
}

TEST_P(ResamplingPolicy, TakesTheOnlyOneThatHasWeight) {
  const auto resampling = makeResampling(GetParam());
  for (const std::size_t only : {0, 2, 4}) {
    std::vector<double> weights(5, 0.0);
    weights[only] = 1.0;
    RandomStream random(2, only);
    EXPECT_EQ(resampling->draw(weights, 6, random),
              std::vector<std::uint32_t>(6, std::uint32_t(only)));
  }
}

TEST_P(ResamplingPolicy, StandsWeightsThatDoNotQuiteSumToOne) {
  const auto resampling = makeResampling(GetParam());
  for (int seed = 0; seed < 2000; ++seed) {
    std::vector<double> weights(10, 0.1 - 1e-3);
    weights.push_back(0.0);
    RandomStream random(std::uint64_t(seed), 0);
    const auto drawn = resampling->draw(weights, 50, random);
    ASSERT_EQ(drawn.size(), 50u);
    ASSERT_LT(drawn.back(), 10u) << "one without weight";
  }
}

INSTANTIATE_TEST_SUITE_P(All, ResamplingPolicy, testing::ValuesIn(resamplingNames()),
                         [](const auto& name) { return name.param; });

TEST(SystematicResamplingTest, IsNeverFurtherThanOneFromTheExpectedNumber) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    RandomStream random(seed, 0);
    std::vector<double> counts(kWeights.size(), 0.0);
    for (const auto i : SystematicResampling().draw(kWeights, kCount, random)) counts[i] += 1;
    for (std::size_t i = 0; i < counts.size(); ++i)
      ASSERT_LT(std::abs(counts[i] - kCount * kWeights[i]), 1.0) << i;
  }
}

TEST(ResidualResamplingTest, GivesTheWholePartForCertain) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    RandomStream random(seed, 0);
    std::vector<double> counts(kWeights.size(), 0.0);
    for (const auto i : ResidualResampling().draw(kWeights, kCount, random)) counts[i] += 1;
    for (std::size_t i = 0; i < counts.size(); ++i)
      ASSERT_GE(counts[i], std::floor(kCount * kWeights[i])) << i;
  }
}

TEST(ResamplingVariance, IsSmallerThanThatOfIndependentDraws) {
  const double multinomial = sum(offspringOf("multinomial").variance);
  double exact = 0.0;
  for (const double w : kWeights) exact += kCount * w * (1 - w);
  EXPECT_NEAR(multinomial, exact, 0.05 * exact);
  EXPECT_LT(sum(offspringOf("stratified").variance), 0.5 * multinomial);
  EXPECT_LT(sum(offspringOf("residual").variance), 0.5 * multinomial);
  EXPECT_LT(sum(offspringOf("systematic").variance), 0.2 * multinomial);
}

TEST(ResampledAlong, NamesAncestorsByTheirOwnNumbers) {
  RandomStream random(3, 0);
  const std::vector<double> weights = {0.0, 0.5, 0.0, 0.5};
  EXPECT_EQ(resampledAlong({3, 2, 1, 0}, SystematicResampling(), weights, 4, random),
            (std::vector<std::uint32_t>{3, 3, 1, 1}));
}

TEST(HilbertIndex, NumbersEveryCellOnceAndGoesFromNeighbourToNeighbour) {
  constexpr std::uint32_t kSide = 8;
  std::vector<Eigen::Vector3i> cells(kSide * kSide * kSide, Eigen::Vector3i::Constant(-1));
  for (std::uint32_t x = 0; x < kSide; ++x)
    for (std::uint32_t y = 0; y < kSide; ++y)
      for (std::uint32_t z = 0; z < kSide; ++z)
        cells.at(hilbertIndex(x, y, z, 3)) = Eigen::Vector3i(int(x), int(y), int(z));
  for (std::size_t i = 1; i < cells.size(); ++i)
    ASSERT_EQ((cells[i] - cells[i - 1]).cwiseAbs().sum(), 1) << i;
}

TEST(HilbertOrder, PutsNeighboursTogether) {
  RandomStream random(4, 0);
  std::vector<Pose2> poses;
  for (int i = 0; i < 200; ++i) {
    const double side = i % 2 == 0 ? -3.0 : 3.0;  // two clouds, by turns
    poses.emplace_back(side + 0.1 * random.gaussian(), 0.1 * random.gaussian(), 0.0);
  }
  const auto order = hilbertOrder(poses, {Pose2(), Eigen::Vector3d(9, 1, 1).asDiagonal()});
  EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), poses.size());
  int jumps = 0;
  for (std::size_t i = 1; i < order.size(); ++i) jumps += order[i] % 2 != order[i - 1] % 2;
  EXPECT_EQ(jumps, 1);
}

TEST(KldSize, AsksForWhatFoxsFormulaSays) {
  KldSize::Limits limits;
  limits.error = 0.05;
  limits.quantile = 2.33;
  const KldSize size(limits);
  EXPECT_EQ(size.neededFor(1), 1.0);
  // (k - 1) / (2 epsilon) (1 - 2 / (9 (k - 1)) + sqrt(2 / (9 (k - 1))) z)^3, k = 11
  EXPECT_NEAR(size.neededFor(11), 232.5, 0.5);
  EXPECT_GT(size.neededFor(100), size.neededFor(50));
}

TEST(KldSize, FollowsTheSpreadOfThePosesBetweenItsBounds) {
  KldSize::Limits limits;
  limits.min = 20;
  limits.max = 400;
  const KldSize size(limits);
  const auto drawn = [&](double spread) {
    std::vector<Pose2> poses;
    RandomStream random(6, 0);
    for (int i = 0; i < 500; ++i) poses.emplace_back(spread * random.gaussian(), 0.0, 0.0);
    RandomStream draws(6, 1);
    return size.drawnFrom(poses, std::vector<double>(500, 1.0 / 500), draws);
  };
  EXPECT_EQ(drawn(1e-4), 20u);
  EXPECT_GT(drawn(0.1), 50u);
  EXPECT_LT(drawn(0.1), 400u);
  EXPECT_EQ(drawn(10.0), 400u);
}

TEST(KldSize, TakesAllItMayInBinsThatAreTooNarrowForTwo) {
  KldSize::Limits limits;
  limits.min = 20;
  limits.max = 400;
  limits.bin_position = 1e-30;
  std::vector<Pose2> poses;
  RandomStream random(6, 0), draws(6, 1);
  for (int i = 0; i < 500; ++i) poses.emplace_back(random.gaussian(), random.gaussian(), 0.0);
  EXPECT_EQ(KldSize(limits).drawnFrom(poses, std::vector<double>(500, 1.0 / 500), draws), 400u);
}

TEST(WeightsTest, AreNormalisedHoweverSmallTheFactors) {
  Weights weights(3);
  EXPECT_TRUE(weights.multiply({-1000.0, -1000.0 + std::log(2.0), -1000.0 + std::log(5.0)}));
  EXPECT_NEAR(weights[0], 1.0 / 8, 1e-12);
  EXPECT_NEAR(weights[1], 2.0 / 8, 1e-12);
  EXPECT_TRUE(weights.multiply({0, 0, 0}));
  EXPECT_NEAR(weights[2], 5.0 / 8, 1e-12);
  EXPECT_NEAR(weights.effectiveSize(), 64.0 / (1 + 4 + 25), 1e-9);
}

TEST(WeightsTest, OutliveAThousandStepsInWhichOneIsFarBetter) {
  Weights weights(2);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(weights.multiply({-1e6, 0.0}));
  EXPECT_EQ(weights[1], 1.0);
  EXPECT_NEAR(weights.effectiveSize(), 1.0, 1e-12);
}

TEST(WeightsTest, AreMadeEqualWhenNothingIsLeftOfThem) {
  const double nothing = -std::numeric_limits<double>::infinity();
  Weights weights(4);
  EXPECT_TRUE(weights.multiply({std::nan(""), nothing, 0.0, 0.0}));
  EXPECT_EQ(weights[0], 0.0) << "what is no number counts as zero";
  EXPECT_EQ(weights[2], 0.5);
  EXPECT_FALSE(weights.multiply({0.0, 0.0, nothing, std::nan("")}));
  EXPECT_EQ(weights.all(), std::vector<double>(4, 0.25));
}

}  // namespace
}  // namespace slam::particle_filter
