// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "slam_ros/conversions.hpp"
#include "slam_ros/markers.hpp"

namespace slam_ros {
namespace {

using visualization_msgs::Marker;

/// A point, and a wall on the left that was seen from 3 m behind to 1 m ahead.
slam::LandmarkMap pointAndWall() {
  slam::LandmarkMap map(2);
  map[0].id = 3;
  map[1].id = 4;
  map[1].position = {1.0, 2.0};
  map[1].kind = slam::LandmarkKind::kLine;
  map[1].direction = M_PI / 2;
  map[1].extent = {-1.0, 3.0};
  return map;
}

TEST(LandmarkMessages, ObservationsKeepTheirKind) {
  slam::LandmarkObservationArray array;
  array.observations.resize(2);
  array.observations[1].kind = slam::LandmarkKind::kLine;
  array.observations[1].extent = {-1.5, 2.5};
  const auto same = fromMsg(toMsg(array)).observations;
  ASSERT_EQ(same.size(), 2u);
  EXPECT_FALSE(same[0].isLine());
  EXPECT_TRUE(same[1].isLine());
  EXPECT_EQ(same[1].extent.begin, -1.5);
  EXPECT_EQ(same[1].extent.end, 2.5);
}

TEST(LandmarkMessages, KeepDescriptors) {
  slam::LandmarkObservationArray array;
  array.observations.resize(2);
  array.observations[1].descriptor = slam::descriptorOf(0.25, 0.125);
  const auto same = fromMsg(toMsg(array)).observations;
  EXPECT_TRUE(same[0].descriptor.isEmpty());
  EXPECT_EQ(same[1].descriptor.values, array.observations[1].descriptor.values);
  EXPECT_EQ(same[1].descriptor.sigmas, array.observations[1].descriptor.sigmas);
  auto map = pointAndWall();
  map[0].descriptor = array.observations[1].descriptor;
  const auto message = toMsg(map, slam::Stamp(), "map");
  EXPECT_EQ(message.landmarks[0].descriptor, std::vector<float>{0.25F});
  EXPECT_EQ(message.landmarks[0].descriptor_sigma, std::vector<float>{0.125F});
  EXPECT_TRUE(message.landmarks[1].descriptor.empty());
}

TEST(LandmarkMessages, ADescriptorThatIsTooLongIsStillTooLong) {
  slam_msgs::LandmarkObservationArray message;
  message.observations.resize(1);
  message.observations[0].descriptor.resize(5000);
  message.observations[0].descriptor_sigma.resize(5000);
  EXPECT_EQ(faultOf(fromMsg(message).observations[0].descriptor),
            " has a descriptor of more than 8 elements");
}

TEST(LandmarkMessages, AMapTellsPointsFromLines) {
  const auto message = toMsg(pointAndWall(), slam::Stamp(), "map");
  EXPECT_EQ(message.landmarks[0].kind, slam_msgs::Landmark::POINT);
  EXPECT_EQ(message.landmarks[1].kind, slam_msgs::Landmark::LINE);
  EXPECT_EQ(message.landmarks[1].direction, M_PI / 2);
  EXPECT_EQ(message.landmarks[1].begin, -1.0);
  EXPECT_EQ(message.landmarks[1].end, 3.0);
}

TEST(LandmarkMarkers, DrawALineAsLongAsItWasSeen) {
  std_msgs::Header header;
  header.frame_id = "map";
  int lines = 0, ellipses = 0;
  for (const auto& marker : toMarkers(pointAndWall(), header).markers) {
    ellipses += marker.ns == "ellipse" ? 1 : 0;
    if (marker.type != Marker::LINE_LIST) continue;
    ++lines;
    EXPECT_EQ(marker.id, 4);
    ASSERT_EQ(marker.points.size(), 2u);
    EXPECT_EQ(marker.points[0].x, -1.0) << "along the wall";
    EXPECT_EQ(marker.points[1].x, 3.0);
    EXPECT_NEAR(std::abs(marker.pose.orientation.z), 1.0, 1e-12) << "which runs backwards";
  }
  EXPECT_EQ(lines, 1);
  EXPECT_EQ(ellipses, 1) << "of the point";
}

bool clearsFirst(const visualization_msgs::MarkerArray& array) {
  return array.markers.front().action == Marker::DELETEALL;
}

TEST(LandmarkMarkers, ClearWhatNoLongerIsInTheMapAndWhatRanBefore) {
  LandmarkMarkers markers;
  auto map = pointAndWall();
  const auto first = markers.next(map, {});
  EXPECT_TRUE(clearsFirst(first));
  EXPECT_EQ(first.markers.size(), 1 + toMarkers(map, {}).markers.size());
  EXPECT_FALSE(clearsFirst(markers.next(map, {})));
  map.push_back(map.back());
  map.back().id = 9;
  EXPECT_FALSE(clearsFirst(markers.next(map, {}))) << "one was added";
  map.back().id = 10;
  EXPECT_TRUE(clearsFirst(markers.next(map, {}))) << "one took the place of another";
  map.back().kind = slam::LandmarkKind::kPoint;
  EXPECT_TRUE(clearsFirst(markers.next(map, {}))) << "a wall has other markers than a point";
  map.clear();
  EXPECT_EQ(markers.next(map, {}).markers.size(), 1U);
}

}  // namespace
}  // namespace slam_ros
