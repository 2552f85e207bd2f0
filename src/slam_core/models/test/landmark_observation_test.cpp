// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_observation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/models/landmark_sensor.hpp"

namespace slam {
namespace {

LandmarkObservation goodObservation() {
  LandmarkObservation z;
  z.id = 7;
  z.range = 2.0;
  z.bearing = -0.4;
  z.covariance << 0.01, 0.001, 0.001, 0.0004;
  return z;
}

TEST(LandmarkObservationFault, IsEmptyForAGoodObservation) {
  EXPECT_EQ(faultOf(goodObservation()), "");
}

TEST(LandmarkObservationFault, NamesTheLandmarkAndWhatIsWrong) {
  auto z = goodObservation();
  z.range = std::nan("");
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "not a number"}));
  z = goodObservation();
  z.bearing = INFINITY;
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "not a number"}));
  z.bearing = 0.0;
  z.range = 1e155;
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "range that no sensor reaches"}));
  z.range = 1e-300;
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "range of 1e-300 m, less than 0.001 m"}));
  z.range = 2.0;
  z.bearing = -1e12;
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "bearing of -1e+12 rad"}));
  z.bearing = 0.0;
  for (const double range : {0.0, -1.0}) {
    z = goodObservation();
    z.range = range;
    EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "range", "not positive"}));
  }
}

TEST(LandmarkObservationFault, ALineHasALength) {
  auto z = goodObservation();
  z.kind = LandmarkKind::kLine;
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "a line of which no part was seen"}));
  z.extent = {-1.0, 2.0};
  EXPECT_EQ(faultOf(z), "");
  z.extent.end = std::nan("");
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "a line of which no part was seen"}));
  z.kind = static_cast<LandmarkKind>(7);
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "neither point nor line"}));
}

TEST(LandmarkObservationFault, KnowsNoNegativeIdButThatOfTheUnknown) {
  auto z = goodObservation();
  z.id = kUnknownId;
  EXPECT_EQ(faultOf(z), "");
  z.id = -7;
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark -7", "impossible id"}));
}

TEST(LandmarkObservationFault, FindsACovarianceThatIsNone) {
  auto z = goodObservation();
  z.covariance(0, 1) = z.covariance(1, 0) = 0.5;  // a correlation above one
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "positive definite"}));
  z.covariance.setZero();
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"positive definite"}));
  z.covariance.setConstant(std::nan(""));
  EXPECT_TRUE(test::oneSays({faultOf(z)}, {"positive definite"}));
}

TEST(LandmarkObservationFault, FindsACovarianceThatIsAbsurdlyLarge) {
  auto z = goodObservation();
  z.covariance = Eigen::Vector2d(1e6, 100.0).asDiagonal();
  EXPECT_EQ(faultOf(z), "");
  for (const int axis : {0, 1})
    for (const double variance : {1e7, 1e12, 1e150, 1.7e308}) {
      z = goodObservation();
      z.covariance = Eigen::Vector2d(0.01, 0.0004).asDiagonal();
      z.covariance(axis, axis) = variance;
      EXPECT_TRUE(
          test::oneSays({faultOf(z)}, {"landmark 7", "standard deviations", "1000 m", "10 rad"}));
    }
}

TEST(LandmarkObservationFault, FindsACovarianceThatIsAbsurdlySmall) {
  auto z = goodObservation();
  z.covariance = 1e-17 * Eigen::Matrix2d::Identity();
  EXPECT_EQ(faultOf(z), "");
  for (const int axis : {0, 1})
    for (const double variance : {1e-19, 1e-100, 1e-300}) {
      z = goodObservation();
      z.covariance = Eigen::Vector2d(0.01, 0.0004).asDiagonal();
      z.covariance(axis, axis) = variance;
      EXPECT_TRUE(test::oneSays({faultOf(z)}, {"landmark 7", "standard deviations", "1e-09"}));
    }
}

TEST(LandmarkSensor, GivesItsNoiseToObservationsThatBringNone) {
  LandmarkObservationArray array;
  array.observations = {goodObservation(), goodObservation()};
  array.observations[1].covariance << -1, 0, 0, 0;
  LandmarkSensorConfig sensor;
  sensor.sigma_range = 0.3;
  sensor.sigma_range_relative = 0.2;
  sensor.sigma_bearing = 0.05;
  completeCovariances(sensor, array);
  EXPECT_EQ(array.observations[0].covariance, goodObservation().covariance);
  Eigen::Matrix2d expected;
  expected << 0.25, 0, 0, 0.0025;  // 0.3^2 + (0.2 * 2)^2
  EXPECT_TRUE(array.observations[1].covariance.isApprox(expected, 1e-12));
  EXPECT_EQ(faultOf(array.observations[1]), "");
}

TEST(LandmarkSensor, RefusesSigmasThatMakeNoCovariance) {
  LandmarkSensorConfig sensor;
  sensor.sigma_range = -0.1;
  sensor.sigma_range_relative = 2;
  sensor.sigma_bearing = 0;
  const auto faults = test::faultsOf([&] { validate(sensor); });
  EXPECT_EQ(faults.size(), 3u);
  EXPECT_TRUE(test::oneSays(faults, {"landmark_sensor.sigma_range", "-0.1", "> 0"}));
  EXPECT_TRUE(test::oneSays(faults, {"landmark_sensor.sigma_range_relative", "[0, 1]"}));
  EXPECT_TRUE(test::oneSays(faults, {"landmark_sensor.sigma_bearing", "> 0"}));
}

}  // namespace
}  // namespace slam
