// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_bias.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/gyro/gyro_noise.hpp"
#include "slam_core/gyro/rest_blocks.hpp"

namespace slam::gyro {
namespace {

constexpr double kSigma = 0.01, kWalk = 2e-5;
constexpr double kWindowVariance = 1e-4;  // of wheels over a second [rad^2/s^2]

TEST(GyroBias, IsKnownFromRestAsWellAsTheNoiseAllows) {
  GyroBias bias(kSigma, 0.0);
  const double noise = 3e-4;
  for (int i = 0; i < 40; ++i) {
    bias.predict(0.25, false);
    bias.observeAtRest(0.02, noise * noise / 0.25);
  }
  EXPECT_NEAR(bias.bias(), 0.02, 1e-4);
  EXPECT_NEAR(std::sqrt(bias.variance()), noise / std::sqrt(10.0), 0.05 * noise);
}

TEST(GyroBias, IsLessCertainTheLongerNobodySeesIt) {
  GyroBias bias(kSigma, kWalk);
  bias.observeAtRest(0.0, 1e-8);
  const double before = bias.variance();
  bias.predict(3600.0, true);
  EXPECT_NEAR(bias.variance() - before, 3600.0 * kWalk * kWalk, 1e-12);
}

/// The increments' variances must add up to that of the heading: a bias of this standard deviation
/// is off by as much all the time.
TEST(GyroBias, AddsUpToTheErrorOfAHeadingOverHalfAMinute) {
  GyroBias bias(kSigma, 0.0);
  for (int i = 0; i < 3000; ++i) bias.predict(0.02, true);  // as on the way
  double sum = 0.0;
  for (int i = 0; i < 1500; ++i) {
    sum += bias.headingVariance(0.02);
    bias.predict(0.02, true);
  }
  EXPECT_NEAR(std::sqrt(sum), 30.0 * kSigma, 0.05 * 30.0 * kSigma);
}

/// As on a robot that steers by slipping and whose driver measures turns half as large again.
TEST(GyroBias, IsNotFooledByWheelsInLongTurns) {
  GyroBias bias(kSigma, kWalk);
  for (int i = 0; i < 4; ++i) bias.observeAtRest(0.004, 3.6e-7);
  for (int i = 0; i < 600; ++i) {
    bias.predict(1.0, true);
    bias.observeBesideWheels(0.004 - 0.5 * 0.4, 0.5, 0.4, kWindowVariance);
  }
  EXPECT_NEAR(bias.bias(), 0.004, 3.0 * std::sqrt(bias.variance()));
  EXPECT_NEAR(bias.bias(), 0.004, 1e-3);
}

TEST(GyroBias, IsNotFooledByUnequalWheelsOnALongStraightWay) {
  GyroBias bias(kSigma, kWalk);
  for (int i = 0; i < 4; ++i) bias.observeAtRest(0.004, 3.6e-7);
  for (int i = 0; i < 600; ++i) {
    bias.predict(1.0, true);
    bias.observeBesideWheels(0.004 - 0.05 * 0.8, 0.8, 0.0, kWindowVariance);
  }
  EXPECT_NEAR(bias.bias(), 0.004, 1e-3);
}

TEST(GyroBias, IsNeverMoreCertainByWheelsThanItsError) {
  double squares = 0.0;
  constexpr int kRobots = 200;
  for (std::uint64_t robot = 0; robot < kRobots; ++robot) {
    RandomStream random(1, robot);
    const double truth = kSigma * random.gaussian(), drift = 0.1 * random.gaussian(),
                 share = 0.5 * random.gaussian();
    GyroBias bias(kSigma, kWalk);
    for (int i = 0; i < 300; ++i) {
      const double speed = i % 50 < 40 ? 0.5 : 0.1, turn = i % 50 < 30 ? 0.0 : 0.3;
      bias.predict(1.0, true);
      bias.observeBesideWheels(truth - drift * speed - share * turn + 0.01 * random.gaussian(),
                               speed, turn, kWindowVariance);
    }
    squares += (bias.bias() - truth) * (bias.bias() - truth) / bias.variance() / kRobots;
  }
  EXPECT_LT(squares, 1.3);
}

TEST(GyroBias, LearnsNothingFromWheelsThatSlip) {
  GyroBias bias(kSigma, kWalk);
  bias.observeAtRest(0.0, 1e-8);
  const double before = bias.variance();
  bias.observeBesideWheels(-3.0, 0.0, 0.0, kWindowVariance);
  EXPECT_EQ(bias.variance(), before);
  EXPECT_NEAR(bias.bias(), 0.0, 1e-9);
}

TEST(GyroNoise, IsThatOfTheGyroWhateverTheFileSays) {
  for (const double truth : {3e-5, 3e-4, 3e-3}) {
    GyroNoise noise(3e-4);
    RandomStream random(3, 1);
    double before = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const double mean = truth / std::sqrt(0.25) * random.gaussian();
      if (i > 0) noise.add(mean - before, 0.25, 0.25);
      before = mean;
    }
    EXPECT_NEAR(std::sqrt(noise.variance()), truth, 0.15 * truth);
  }
}

TEST(RestBlocks, CountWhenTheNextOneMeasuresTheSame) {
  RestBlocks blocks;
  GyroNoise noise(3e-4);
  std::vector<double> rates;
  const auto rest = [&](double rate, int times) {
    for (int i = 0; i < times; ++i)
      if (const auto block = blocks.add(0.05 * rate, 0.05, noise)) rates.push_back(block->rate());
  };
  rest(0.01, 5);
  EXPECT_TRUE(rates.empty()) << "the robot may have begun to move within it";
  rest(0.01, 5);
  ASSERT_EQ(rates.size(), 1u);
  EXPECT_NEAR(rates[0], 0.01, 1e-12);
  rest(0.3, 5);  // somebody turns it
  rest(0.01, 5);
  EXPECT_EQ(rates.size(), 1u);
  rest(0.01, 5);
  EXPECT_EQ(rates.size(), 2u);
}

}  // namespace
}  // namespace slam::gyro
