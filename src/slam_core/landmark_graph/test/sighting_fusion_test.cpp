// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/sighting_fusion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/angle.hpp"

namespace slam::landmark_graph {
namespace {

LandmarkObservation observation(double range, double bearing, const Eigen::Matrix2d& R) {
  LandmarkObservation z;
  z.id = 4;
  z.range = range;
  z.bearing = bearing;
  z.covariance = R;
  return z;
}

Eigen::Matrix2d covariance(double range, double mixed, double bearing) {
  Eigen::Matrix2d R;
  R << range, mixed, mixed, bearing;
  return R;
}

/// What the second sensor would see of what the first one sees.
Eigen::Vector2d carriedOver(const Pose2& a, const Pose2& b, const Eigen::Vector2d& z) {
  const Eigen::Vector2d in_a = z.x() * Eigen::Vector2d(std::cos(z.y()), std::sin(z.y()));
  const Eigen::Vector2d in_b = b.between(a).transform(in_a);
  return {in_b.norm(), std::atan2(in_b.y(), in_b.x())};
}

TEST(SightingFusion, AddsInformationOfOneSensorPose) {
  const Pose2 sensor(0.3, -0.1, 0.7);
  const auto a = observation(3.0, 0.2, covariance(0.02, 0.001, 4e-4));
  const auto b = observation(3.1, 0.22, covariance(0.05, -0.002, 2e-4));
  const auto both = fused(a, sensor, b, sensor);
  ASSERT_TRUE(both);
  const Eigen::Matrix2d A = a.covariance.inverse(), B = b.covariance.inverse();
  const Eigen::Matrix2d P = (A + B).inverse();
  EXPECT_TRUE(both->covariance.isApprox(P, 1e-9));
  EXPECT_TRUE(both->vector().isApprox(P * (A * a.vector() + B * b.vector()), 1e-9));
  EXPECT_EQ(both->id, a.id);
}

TEST(SightingFusion, EqualsAKalmanUpdateInTheSecondSensor) {
  const Pose2 sensor_a(0.2, 0, 0.1), sensor_b(0.25, 0.03, 0.16);
  const auto a = observation(2.0, 0.9, covariance(0.02, 0.003, 0.01));
  const auto b = observation(1.98, 0.8, covariance(0.03, 0, 0.004));
  const Eigen::Vector2d predicted = carriedOver(sensor_a, sensor_b, a.vector());
  Eigen::Matrix2d J;
  constexpr double kDifference = 1e-6;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d step = kDifference * Eigen::Vector2d::Unit(i);
    J.col(i) = (carriedOver(sensor_a, sensor_b, a.vector() + step) -
                carriedOver(sensor_a, sensor_b, a.vector() - step)) /
               (2 * kDifference);
  }
  const Eigen::Matrix2d P = J * a.covariance * J.transpose();
  const Eigen::Matrix2d K = P * (P + b.covariance).inverse();
  const auto both = fused(a, sensor_a, b, sensor_b);
  ASSERT_TRUE(both);
  EXPECT_TRUE(both->vector().isApprox(predicted + K * (b.vector() - predicted), 1e-7));
  EXPECT_TRUE(both->covariance.isApprox((Eigen::Matrix2d::Identity() - K) * P, 1e-7));
  EXPECT_EQ(both->covariance, both->covariance.transpose());
}

TEST(SightingFusion, OfWhatIsUnsureWithWhatIsSureStaysPositiveDefinite) {
  const Pose2 sensor_a(0.2, 0, 0.1), sensor_b(0.7, 0.4, 0.9);
  for (const double sure : {1e-4, 1e-10, 1e-17}) {
    const auto vague = observation(2.0, 0.9, covariance(1e6, 0, 100));
    const auto exact = observation(1.98, 0.8, covariance(sure, 0, sure));
    for (const auto& both :
         {fused(vague, sensor_a, exact, sensor_b), fused(exact, sensor_a, vague, sensor_b)}) {
      ASSERT_TRUE(both);
      EXPECT_EQ(both->covariance.llt().info(), Eigen::Success) << sure;
    }
  }
}

/// Also behind the sensor, where bearings jump between pi and -pi.
TEST(SightingFusion, OfManyNoisyOnesFromOnePlaceIsUnbiasedAndAsSureAsItMayBe) {
  constexpr int kSeeds = 200, kSightings = 300;
  const Eigen::Matrix2d R = covariance(0.04, 0.001, 0.01);
  const Eigen::Matrix2d L = R.llt().matrixL();
  const Eigen::Vector2d truth(2.5, M_PI - 0.02);
  const Pose2 sensor(0.1, 0.2, -0.4);
  double squared = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    RandomStream random(seed, 0);
    const auto next = [&] {
      const Eigen::Vector2d z = truth + L * Eigen::Vector2d(random.gaussian(), random.gaussian());
      return observation(z.x(), wrapAngle(z.y()), R);
    };
    auto all = next();
    for (int i = 1; i < kSightings; ++i) all = fused(all, sensor, next(), sensor).value();
    ASSERT_TRUE(all.covariance.isApprox(R / kSightings, 1e-6));
    const Eigen::Vector2d error(all.range - truth.x(), wrapAngle(all.bearing - truth.y()));
    squared += error.dot(all.covariance.inverse() * error);
    sum += error;
  }
  EXPECT_NEAR(squared / kSeeds, 2.0, 4 * 2 / std::sqrt(kSeeds));
  const Eigen::Vector2d mean = sum / kSeeds;
  EXPECT_LT(mean.dot(R.inverse() * mean) * kSeeds * kSightings, 20.0);  // chi-square, 2 degrees
}

TEST(SightingFusion, GivesNothingWhereTheFirstOnePutsTheLandmarkIntoTheSecondSensor) {
  const auto R = covariance(0.01, 0, 0.01);
  const auto a = observation(1.0, 0, R), b = observation(0.5, 0, R);
  EXPECT_FALSE(fused(a, Pose2(), b, Pose2(1, 0, 0.3)));
  EXPECT_TRUE(fused(a, Pose2(), b, Pose2(0.5, 0, 0)));
}

}  // namespace
}  // namespace slam::landmark_graph
