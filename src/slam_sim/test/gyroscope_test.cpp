// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/gyroscope.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::sim {
namespace {

ImuModel upsideDown() {
  ImuModel imu;
  imu.T_base_imu.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  imu.pace.rate = 100.0;
  return imu;
}

TEST(Gyroscope, MeasuresTheTurnInItsOwnFrame) {
  auto imu = upsideDown();
  imu.gyro_scale = 1.01;
  Gyroscope gyro(imu);
  RandomStream random(1, 1);
  EXPECT_LT((gyro.measure(0.5, random) - Eigen::Vector3d(0.0, 0.0, -0.505)).norm(), 1e-12);
}

TEST(Gyroscope, NoiseOfAnAngleDoesNotDependOnTheRate) {
  for (const double rate : {25.0, 200.0}) {
    auto imu = upsideDown();
    imu.pace.rate = rate;
    imu.gyro_noise = 0.01;
    double squares = 0.0;
    constexpr int kRuns = 500;
    for (std::uint64_t run = 0; run < kRuns; ++run) {
      Gyroscope gyro(imu);
      RandomStream random(2, run);
      double angle = 0.0;
      for (int i = 0; i < 4 * std::lround(rate); ++i) angle += gyro.measure(0.0, random).z() / rate;
      squares += angle * angle / kRuns;
    }
    EXPECT_NEAR(std::sqrt(squares), 0.02, 0.002) << "the density times the root of 4 s";
  }
}

TEST(Gyroscope, BiasWalksAtRandom) {
  auto imu = upsideDown();
  imu.gyro_bias = {0.0, 0.0, 0.3};
  imu.gyro_bias_random_walk = 0.02;
  double mean = 0.0, squares = 0.0;
  constexpr int kRuns = 500;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    Gyroscope gyro(imu);
    RandomStream random(3, run);
    for (int i = 0; i < 899; ++i) gyro.measure(0.0, random);
    const double walked = gyro.measure(0.0, random).z() - 0.3;
    mean += walked / kRuns;
    squares += walked * walked / kRuns;
  }
  EXPECT_NEAR(mean, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares), 0.06, 0.006) << "after 9 s";
}

TEST(TurnRate, IsThatOfThePathAlsoWhereTheHeadingWraps) {
  const auto path = [](double t) { return Pose2(0.0, 0.0, M_PI + 0.7 * t); };
  EXPECT_NEAR(turnRate(path), 0.7, 1e-9);
}

}  // namespace
}  // namespace slam::sim
