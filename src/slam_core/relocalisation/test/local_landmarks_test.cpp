// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/local_landmarks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slam::relocalisation {
namespace {

LandmarkObservationArray seeing(LandmarkId id, double range, double bearing) {
  LandmarkObservation z;
  z.id = id;
  z.range = range;
  z.bearing = bearing;
  z.covariance << 4e-4, 0.0, 0.0, 1e-4;
  LandmarkObservationArray array;
  array.observations = {z};
  return array;
}

Motion moving(double x, double theta) {
  Motion motion;
  motion.increment = Pose2(x, 0.0, theta);
  motion.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  return motion;
}

TEST(LocalLandmarks, StayWhereTheyAreWhenTheRobotMoves) {
  LocalLandmarks landmarks;
  EXPECT_TRUE(landmarks.see(seeing(1, 2.0, 0.0)));
  const double before = landmarks.all()[0].covariance.trace();
  landmarks.move(moving(1.0, M_PI / 2));
  EXPECT_NEAR(landmarks.all()[0].position.x(), 0.0, 1e-9);
  EXPECT_NEAR(landmarks.all()[0].position.y(), -1.0, 1e-9);
  EXPECT_GT(landmarks.all()[0].covariance.trace(), before + 2e-4);
}

TEST(LocalLandmarks, CountAnyNumberOfSightingsAsFour) {
  LocalLandmarks once, often;
  once.see(seeing(1, 2.0, 0.0));
  for (int i = 0; i < 1000; ++i) often.see(seeing(1, 2.0, 0.0));
  ASSERT_EQ(often.all().size(), 1u);
  EXPECT_NEAR(often.all()[0].covariance(0, 0), 0.25 * once.all()[0].covariance(0, 0), 1e-6);
}

TEST(LocalLandmarks, KeepTwoMarkersOfOneIdApart) {
  LocalLandmarks landmarks;
  EXPECT_TRUE(landmarks.see(seeing(1, 2.0, 0.0)));
  EXPECT_TRUE(landmarks.see(seeing(1, 2.0, 0.5)));
  EXPECT_FALSE(landmarks.see(seeing(1, 2.0, 0.5)));
  EXPECT_EQ(landmarks.all().size(), 2u);
}

TEST(LocalLandmarks, IgnoreIdsWhereTheyMeanNothing) {
  LocalLandmarks landmarks(LocalLandmarks::Ids::kIgnored);
  landmarks.see(seeing(1, 2.0, 0.0));
  EXPECT_FALSE(landmarks.see(seeing(7, 2.0, 0.0)));
  EXPECT_EQ(landmarks.all()[0].id, kUnknownId);
}

TEST(LocalLandmarks, ForgetWhatHasBecomeVague) {
  LocalLandmarks landmarks;
  landmarks.see(seeing(1, 2.0, 0.0));
  for (int i = 0; i < 200; ++i) landmarks.move(moving(0.3, 0.0));
  EXPECT_TRUE(landmarks.all().empty());
}

TEST(LocalLandmarks, TakeNothingThatIsNoNumber) {
  LocalLandmarks landmarks;
  landmarks.see(seeing(1, std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_TRUE(landmarks.all().empty());
}

TEST(LocalLandmarks, AreBoundedInNumber) {
  LocalLandmarks landmarks;
  for (int i = 0; i < 500; ++i) landmarks.see(seeing(i, 2.0, 0.01 * i));
  EXPECT_LE(landmarks.all().size(), 40u);
  EXPECT_EQ(landmarks.all().back().id, 499);
}

}  // namespace
}  // namespace slam::relocalisation
