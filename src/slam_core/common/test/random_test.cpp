// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace slam {
namespace {

using Words4 = std::array<std::uint32_t, 4>;

/// Philox 4x32-10 written down from the paper (Salmon et al., SC 2011, sec. 3.3), without a
/// library.
Words4 philox(Words4 c, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0], b = std::uint64_t{0xCD9E8D57} * c[2];
    c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return c;
}

Words4 block(RandomStream& stream) {
  return {stream.bits(), stream.bits(), stream.bits(), stream.bits()};
}

// The published known answers (Random123, tests/kat_vectors): counter, key, output.
TEST(RandomStream, GivesThePublishedAnswerForTheZeroCounter) {
  RandomStream stream(0, 0, 0);
  EXPECT_EQ(block(stream), (Words4{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(RandomStream, LaysOutSeedStepAndParticleAsKeyAndCounter) {
  ASSERT_EQ(philox({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}),
            (Words4{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  ASSERT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words4{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
  RandomStream stream(0x299f31d0a4093822, 0x0370734413198a2e, 0x85a308d3);
  for (std::uint32_t i = 0; i < 3; ++i)
    EXPECT_EQ(block(stream),
              philox({i, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}));
}

TEST(RandomStream, UniformFillsTheUnitIntervalEvenly) {
  RandomStream stream(1, 2);
  constexpr int kDraws = 200000, kBins = 20;
  std::array<int, kBins> bins{};
  for (int i = 0; i < kDraws; ++i) {
    const double u = stream.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++bins[static_cast<std::size_t>(u * kBins)];
  }
  double chi_square = 0.0;
  const double expected = double(kDraws) / kBins;
  for (const int count : bins) chi_square += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_square, 43.8);  // 0.999 quantile with 19 degrees of freedom
  EXPECT_GT(chi_square, 5.4);   // 0.001 quantile: nor too even to be random
}

TEST(RandomStream, GaussianHasTheMomentsOfTheStandardNormal) {
  RandomStream stream(3, 4);
  constexpr int kDraws = 400000;
  std::array<double, 5> moment{};
  double lag = 0.0, last = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double g = stream.gaussian();
    for (unsigned k = 1; k <= 4; ++k) moment[k] += std::pow(g, k) / kDraws;
    lag += g * last / kDraws;
    last = g;
  }
  // bounds of five standard errors: sqrt(1, 2, 15, 96) / sqrt(kDraws)
  EXPECT_NEAR(moment[1], 0.0, 0.008);
  EXPECT_NEAR(moment[2], 1.0, 0.012);
  EXPECT_NEAR(moment[3], 0.0, 0.031);
  EXPECT_NEAR(moment[4], 3.0, 0.078);
  EXPECT_NEAR(lag, 0.0, 0.008);
}

TEST(RandomStream, DoesNotDependOnWhoDrawsFirst) {
  RandomStream a_first(5, 0, 1), b_second(5, 0, 2);
  std::vector<double> a, b;
  for (int i = 0; i < 9; ++i) a.push_back(a_first.gaussian());
  for (int i = 0; i < 9; ++i) b.push_back(b_second.gaussian());
  RandomStream a_again(5, 0, 1), b_again(5, 0, 2);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(b_again.gaussian(), b[i]);
    EXPECT_EQ(a_again.gaussian(), a[i]);
  }
}

TEST(RandomStream, DiffersBySeedStepAndParticle) {
  std::set<std::uint32_t> first;
  for (const std::uint64_t seed : {1ull, 2ull, 1ull << 32})
    for (const std::uint64_t step : {0ull, 1ull, 1ull << 32})
      for (const std::uint32_t particle : {0u, 1u, 2u})
        first.insert(RandomStream(seed, step, particle).bits());
  EXPECT_EQ(first.size(), 27u);
}

}  // namespace
}  // namespace slam
