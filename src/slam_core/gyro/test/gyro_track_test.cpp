// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_track.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::gyro {
namespace {

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

class GyroTrackTest : public testing::Test {
 protected:
  void add(double s, double rate, double variance = 0.0) {
    ImuSample sample;
    sample.stamp = at(s);
    sample.angular_velocity = {7.0, -7.0, rate};
    sample.covariance(2, 2) = variance;
    track.add(sample, counters);
  }

  GyroTrack track;
  Counters counters;
};

TEST_F(GyroTrackTest, IntegratesWhatIsLinearBetweenSamples) {
  for (int i = 0; i <= 20; ++i) add(0.05 * i, 0.1 * i);  // 2 rad/s^2
  const auto turn = track.between(at(0.12), at(0.87));
  ASSERT_TRUE(turn);
  EXPECT_NEAR(turn->angle, 0.87 * 0.87 - 0.12 * 0.12, 1e-12);
  EXPECT_NEAR(turn->seconds, 0.75, 1e-12);
  double seconds = 0.0, angle = 0.0;
  for (const auto& piece : turn->pieces) seconds += piece.seconds, angle += piece.angle;
  EXPECT_NEAR(seconds, turn->seconds, 1e-12);
  EXPECT_NEAR(angle, turn->angle, 1e-12);
}

TEST_F(GyroTrackTest, DoesNotKnowWhatSamplesDoNotCover) {
  for (const double s : {1.0, 1.05, 1.1, 1.4, 1.45, 1.5}) add(s, 0.2);
  EXPECT_FALSE(track.between(at(0.99), at(1.05))) << "it begins before the first";
  EXPECT_FALSE(track.between(at(1.45), at(1.51))) << "it ends behind the last";
  EXPECT_FALSE(track.between(at(1.05), at(1.45))) << "there is a hole in it";
  EXPECT_TRUE(track.between(at(1.0), at(1.1)));
  EXPECT_TRUE(track.between(at(1.4), at(1.5)));
  EXPECT_EQ(track.end(), at(1.5));
}

TEST_F(GyroTrackTest, LeavesOutSamplesThatAreLateOrThatJumpAlone) {
  for (const double s : {1.0, 1.1, 1.05, 1.1, 50.0, 1.2, 1.3, -20.0, 1.4}) add(s, 0.3);
  EXPECT_EQ(counters["gyro_late"], 2u);
  EXPECT_EQ(counters["gyro_stamp_jump"], 2u);
  EXPECT_NEAR(track.between(at(1.0), at(1.4))->angle, 0.12, 1e-12);
}

TEST_F(GyroTrackTest, GoesOnAfterAJumpThatTheNextSampleConfirms) {
  for (const double s : {1.0, 1.1, 50.0, 50.1, 50.2}) add(s, 0.3);
  EXPECT_EQ(counters["gyro_stamp_jump"], 0u);
  EXPECT_NEAR(track.between(at(50.0), at(50.2))->angle, 0.06, 1e-12);
  for (const double s : {2.0, 2.1}) add(s, 0.3);
  EXPECT_NEAR(track.between(at(2.0), at(2.1))->angle, 0.03, 1e-12) << "a new run";
}

TEST_F(GyroTrackTest, NotesAValueThatComesAgainAndAgain) {
  for (int i = 0; i < 10; ++i) add(0.01 * i, 0.01 * i);
  for (int i = 10; i < 30; ++i) add(0.01 * i, 0.5);
  EXPECT_FALSE(track.between(at(0.05), at(0.09))->is_repeated);
  EXPECT_FALSE(track.between(at(0.09), at(0.29))->is_repeated) << "it has changed in between";
  EXPECT_FALSE(track.between(at(0.10), at(0.15))->is_repeated) << "that may be chance";
  EXPECT_TRUE(track.between(at(0.20), at(0.29))->is_repeated);
}

TEST_F(GyroTrackTest, AddsUpWhatTheDriverSaysOfTheNoise) {
  for (int i = 0; i <= 100; ++i) add(0.01 * i, 0.2, 4e-4);  // a density of 2e-3
  EXPECT_NEAR(track.between(at(0.0), at(1.0))->given_variance, 4e-6, 1e-12);
}

TEST_F(GyroTrackTest, ForgetsWhatIsNotAskedForAnyMore) {
  for (int i = 0; i <= 100; ++i) add(0.01 * i, 0.2);
  track.forgetBefore(at(0.555));
  EXPECT_FALSE(track.between(at(0.5), at(0.6)));
  EXPECT_TRUE(track.between(at(0.555), at(0.6)));
}

}  // namespace
}  // namespace slam::gyro
