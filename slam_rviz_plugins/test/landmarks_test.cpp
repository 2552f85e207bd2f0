// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "landmark_places.hpp"
#include "landmark_text.hpp"

// What the tool shows of a landmark, and which one it finds under the mouse.

namespace slam_rviz_plugins {
namespace {

TEST(LandmarkText, NamesIdAndPositionWithSigma) {
  slam_msgs::Landmark landmark;
  landmark.id = 12;
  landmark.x = 1.5;
  landmark.y = -0.25;
  landmark.covariance = {0.0004, 0.0, 0.0, 0.0009};
  EXPECT_EQ(describe(landmark).join("\n").toStdString(),
            "landmark 12\nx 1.500 m, σ 0.020 m\ny -0.250 m, σ 0.030 m");
}

TEST(LandmarkText, NamesTheLabelBehindTheId) {
  slam_msgs::Landmark landmark;
  landmark.id = 12;
  slam_msgs::LandmarkLabels labels;
  labels.ids = {3, 12, 15};
  labels.labels = {"gate", "door"};  // one is lacking
  EXPECT_EQ(describe(landmark, labelOf(landmark, labels)).front(), "landmark 12: door");
  landmark.id = 15;
  EXPECT_EQ(describe(landmark, labelOf(landmark, labels)).front(), "landmark 15");
}

TEST(LandmarkText, NamesDirectionAndLengthOfAWall) {
  slam_msgs::Landmark landmark;
  landmark.id = 3;
  landmark.kind = slam_msgs::Landmark::LINE;
  landmark.x = 2.0;
  landmark.y = 1.0;
  landmark.direction = 1.25;
  landmark.begin = -0.5;
  landmark.end = 2.0;
  landmark.covariance = {0.0001, 0.0, 0.0, 0.000025};
  EXPECT_EQ(describe(landmark).join("\n").toStdString(),
            "landmark 3, a wall\nthrough x 2.000 m, y 1.000 m, σ across it 0.010 m\n"
            "its perpendicular points to 1.250 rad, σ 0.005 rad\n2.50 m of it were seen");
}

TEST(LandmarkText, NamesTheDescriptorWhereThereIsOne) {
  slam_msgs::Landmark landmark;
  landmark.descriptor = {0.15F, 2.0F};
  landmark.descriptor_sigma = {0.01F};
  EXPECT_EQ(describe(landmark).last().toStdString(), "descriptor 0.15 (σ 0.01), 2");
}

QLineF pointAt(double x, double y) { return {x, y, x, y}; }

TEST(LandmarkPlaces, TheNearestWithinReachIsFound) {
  const std::vector<LandmarkPlace> places = {{4, pointAt(100, 100)}, {7, pointAt(110, 100)}};
  EXPECT_EQ(nearestTo({107, 100}, places, 12.0), 7U);
  EXPECT_EQ(nearestTo({105, 100}, places, 12.0), 4U);  // as near as the other, and before it
  EXPECT_EQ(nearestTo({122, 100}, places, 12.0), 7U);
  EXPECT_EQ(nearestTo({123, 100}, places, 12.0), std::nullopt);
  EXPECT_EQ(nearestTo({107, 100}, {}, 12.0), std::nullopt);
}

TEST(LandmarkPlaces, AWallIsFoundAlongThePartThatWasSeen) {
  const std::vector<LandmarkPlace> places = {{0, {100, 100, 200, 100}}, {1, pointAt(150, 115)}};
  EXPECT_EQ(nearestTo({130, 95}, places, 12.0), 0U);
  EXPECT_EQ(nearestTo({150, 112}, places, 12.0), 1U);
  EXPECT_EQ(nearestTo({213, 100}, places, 12.0), std::nullopt);
}

}  // namespace
}  // namespace slam_rviz_plugins
