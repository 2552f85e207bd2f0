// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/place_agreement.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

Motion straightOn(double way) {
  Motion motion;
  motion.increment = Pose2(way, 0.0, 0.0);
  return motion;
}

/// Drives on by a way between each two images.
/// @return how many images it took; 0 if ten do not do
int imagesUntilFound(double way, const Pose2& first, const Pose2& apart) {
  PlaceAgreement agreement;
  Pose2 place = first;
  for (int image = 1; image <= 10; ++image) {
    if (agreement.add(place)) return image;
    agreement.move(straightOn(way));
    place = place * apart;
  }
  return 0;
}

const Pose2 kStart(3.0, -1.0, 2.0);

TEST(PlaceAgreement, TakesThreeImagesWhosePlacesAreWhereOdometryLeads) {
  EXPECT_EQ(imagesUntilFound(0.1, kStart, Pose2(0.1, 0.0, 0.0)), 3);
}

TEST(PlaceAgreement, LeavesOutImagesBetweenWhichTheRobotHasHardlyMoved) {
  EXPECT_EQ(imagesUntilFound(0.02, kStart, Pose2(0.02, 0.0, 0.0)), 5);
}

TEST(PlaceAgreement, IsNeverReachedByARobotThatStands) {
  EXPECT_EQ(imagesUntilFound(0.0, kStart, Pose2()), 0);
}

TEST(PlaceAgreement, IsNeverReachedByAPictureThatStaysWhileTheRobotDrives) {
  EXPECT_EQ(imagesUntilFound(0.2, kStart, Pose2()), 0);
}

TEST(PlaceAgreement, BeginsAnewWhereAPlaceIsElsewhere) {
  PlaceAgreement agreement;
  const auto seen = [&](double x) {
    agreement.move(straightOn(0.1));
    return agreement.add(Pose2(x, 0.0, 0.0));
  };
  EXPECT_FALSE(seen(0.0));
  EXPECT_FALSE(seen(0.1));
  EXPECT_FALSE(seen(5.0));
  EXPECT_FALSE(seen(5.1));
  EXPECT_TRUE(seen(5.2));
}

}  // namespace
}  // namespace slam
