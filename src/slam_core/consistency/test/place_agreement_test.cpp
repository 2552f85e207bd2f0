// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/place_agreement.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

Motion odometryStep(const Pose2& increment) {
  Motion motion;
  motion.increment = increment;
  return motion;
}

/// @param step of odometry between two images @param apart how far their places are apart
/// @return how many images it took; 0 if a hundred do not do
int imagesUntilFound(const Pose2& step, const Pose2& apart) {
  PlaceAgreement agreement;
  Pose2 place(3.0, -1.0, 2.0);
  for (int image = 1; image <= 100; ++image) {
    if (agreement.add(place)) return image;
    agreement.move(odometryStep(step));
    place = place * apart;
  }
  return 0;
}

TEST(PlaceAgreement, TakesThreeImagesWhosePlacesAreWhereOdometryLeads) {
  const Pose2 step(0.3, 0.0, 0.0), turn(0.0, 0.0, 0.2);
  EXPECT_EQ(imagesUntilFound(step, step), 3);
  EXPECT_EQ(imagesUntilFound(turn, turn), 3) << "a robot that turns sees its place anew, too";
}

TEST(PlaceAgreement, TakesMoreWhereTheRobotHasHardlyMoved) {
  const Pose2 step(0.06, 0.0, 0.0);
  EXPECT_EQ(imagesUntilFound(step, step), 5) << "after 0.24 m";
}

TEST(PlaceAgreement, IsNeverReachedByARobotThatStands) {
  EXPECT_EQ(imagesUntilFound(Pose2(), Pose2()), 0);
}

TEST(PlaceAgreement, IsNeverReachedByAPictureThatStaysWhileTheRobotDrivesOrTurns) {
  for (const double way : {0.0, 0.02, 0.06, 0.1, 0.14, 0.2, 0.3})
    for (const double turn : {0.0, 0.02, 0.06, 0.09, 0.12, 0.2})
      EXPECT_EQ(imagesUntilFound(Pose2(way, 0.0, turn), Pose2()), 0) << way << " m, " << turn;
}

TEST(PlaceAgreement, BeginsAnewWhereAPlaceIsElsewhere) {
  PlaceAgreement agreement;
  const auto seen = [&](double x) {
    agreement.move(odometryStep(Pose2(0.3, 0.0, 0.0)));
    return agreement.add(Pose2(x, 0.0, 0.0));
  };
  EXPECT_FALSE(seen(0.0));
  EXPECT_FALSE(seen(0.3));
  EXPECT_FALSE(seen(5.0));
  EXPECT_FALSE(seen(5.3));
  EXPECT_TRUE(seen(5.6));
}

}  // namespace
}  // namespace slam
