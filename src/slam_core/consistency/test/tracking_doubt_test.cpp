// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/tracking_doubt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam {
namespace {

constexpr double kUsualShare = 0.75, kUsualDeviation = 0.1, kByChance = 0.12;

/// Images of a robot that drives at 0.5 m/s, with a number of features in view.
class Images {
 public:
  explicit Images(std::uint64_t seed, double false_alarm_hours = 100.0, double interval = 0.1)
      : random_(seed, 0), interval_(interval), doubt_(false_alarm_hours) {}

  /// @param share that is found in the mean @param deviation of the share from image to image
  void add(double share, double deviation, std::size_t expected = 30) {
    const double p = std::clamp(share + deviation * random_.gaussian(), 0.0, 1.0);
    ViewOfMap view{expected, 0};
    for (std::size_t i = 0; i < expected; ++i) view.found += random_.uniform() < p ? 1 : 0;
    time_ += interval_;
    doubt_.judge(view, Pose2(0.5 * time_, 0.0, 0.0), Stamp(durationFromSeconds(time_)));
  }
  void addRight(int count) {
    for (int i = 0; i < count; ++i) add(kUsualShare, kUsualDeviation);
  }
  void addLost() { add(kByChance, 0.1); }
  TrackingDoubt& doubt() { return doubt_; }

 private:
  RandomStream random_;
  double interval_, time_ = 0.0;
  TrackingDoubt doubt_;
};

TEST(TrackingDoubt, RaisesNoMoreFalseAlarmsThanItClaims) {
  constexpr double kHours = 0.1;  // of independent images, of which there are 9000 in an hour
  constexpr int kImages = 100000;
  int alarms = 0;
  for (const double share : {0.4, 0.55, kUsualShare, 0.95}) {
    Images images(7, kHours, 0.4);
    for (int i = 0; i < kImages; ++i) {
      images.add(share, kUsualDeviation);
      if (!images.doubt().isLost()) continue;
      ++alarms;
      images.doubt().settle();
    }
  }
  EXPECT_LE(alarms, 4 * kImages / (kHours * 9000.0));
}

TEST(TrackingDoubt, TellsALossWithinASecond) {
  double sum = 0.0;
  constexpr int kDrives = 300;
  for (int drive = 0; drive < kDrives; ++drive) {
    Images images(static_cast<std::uint64_t>(100 + drive));
    images.addRight(200);
    ASSERT_FALSE(images.doubt().isLost());
    int count = 0;
    for (; !images.doubt().isLost() && count < 100; ++count) images.addLost();
    EXPECT_LE(count, 20);
    sum += count;
  }
  EXPECT_LT(sum / kDrives, 9.0) << "images, ten a second";
}

TEST(TrackingDoubt, IsNoneOfARobotWhoseViewIsHiddenInPartOrForAMoment) {
  Images images(3);
  images.addRight(200);
  for (int i = 0; i < 50; ++i) images.add(0.5, 0.05);
  EXPECT_FALSE(images.doubt().isLost());
  images.addRight(50);
  for (int i = 0; i < 3; ++i) images.add(0.0, 0.0);
  EXPECT_FALSE(images.doubt().isLost());
  EXPECT_TRUE(images.doubt().doubtedSince().has_value());
  EXPECT_FALSE(images.doubt().admits());
  images.addRight(30);
  EXPECT_FALSE(images.doubt().doubtedSince().has_value());
  EXPECT_TRUE(images.doubt().admits());
}

TEST(TrackingDoubt, IsNotRaisedByAFewFeaturesThatHaveGone) {
  Images images(6);
  images.addRight(200);
  for (int i = 0; i < 300; ++i) images.add(0.0, 0.0, 9);
  EXPECT_FALSE(images.doubt().isLost());
}

TEST(TrackingDoubt, FadesWhereNothingIsExpected) {
  Images images(4);
  images.addRight(200);
  for (int i = 0; i < 3; ++i) images.addLost();
  EXPECT_TRUE(images.doubt().doubtedSince().has_value());
  for (int i = 0; i < 100; ++i) images.add(0.0, 0.0, 3);
  EXPECT_FALSE(images.doubt().doubtedSince().has_value());
  EXPECT_FALSE(images.doubt().isLost());
}

TEST(TrackingDoubt, LastsUntilThePoseIsKnownAndNamesTheImageWithWhichItBegan) {
  Images images(5);
  images.addRight(200);
  for (int i = 0; i < 30; ++i) images.addLost();
  ASSERT_TRUE(images.doubt().isLost());
  const double since = seconds(images.doubt().lostSince()->time_since_epoch());
  EXPECT_NEAR(since, 20.1, 0.15);
  images.addRight(50);
  EXPECT_TRUE(images.doubt().isLost());
  EXPECT_FALSE(images.doubt().admits());
  images.doubt().settle();
  EXPECT_FALSE(images.doubt().isLost());
}

}  // namespace
}  // namespace slam
