// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/visual_map.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "slam_core/mono_graph/pose_chain.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"

namespace slam::mono_graph {
namespace {

/// Two keyframes with four features each.
VisualMap twoKeyframes() {
  VisualMap map;
  for (int i = 0; i < 2; ++i) {
    Keyframe keyframe;
    keyframe.features =
        Features(std::vector<Feature>(4), NormalisedCamera(test::RoomOfPictures::mount()), 500.0);
    map.add(std::move(keyframe));
  }
  return map;
}

MapPoint pointSeenBy(std::vector<Sighting> sightings) {
  MapPoint point;
  point.sightings = std::move(sightings);
  return point;
}

/// A lens of nearly 180 degrees has corners far out on the plane z = 1.
TEST(Features, AreFoundAtTheBorderOfAVeryWideLens) {
  std::vector<Feature> features(40);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto n = static_cast<double>(i);
    features[i].seen = {-57.0 + 3.0 * n, 57.0 - 2.5 * n};
  }
  const Features wide(features, NormalisedCamera(test::RoomOfPictures::mount()), 300.0);
  for (std::size_t i = 0; i < features.size(); ++i) {
    std::vector<std::size_t> found;
    wide.near(features[i].seen, 1.0, found);
    EXPECT_EQ(found, std::vector<std::size_t>{i});
  }
}

TEST(VisualMap, KeepsNoSightingOfAPointThatIsGone) {
  auto map = twoKeyframes();
  const int point = map.add(pointSeenBy({{0, 1}, {1, 2}}));
  map.remove(point);
  EXPECT_FALSE(map.addSighting(point, {1, 3}));
  EXPECT_TRUE(map.point(point).isGone());
  EXPECT_EQ(map.keyframe(1).points[3], kNoPoint);
}

/// Else a keyframe would be left with a point that is gone.
TEST(VisualMap, GivesThePlaceOfAPointThatIsGoneToOneOtherPoint) {
  auto map = twoKeyframes();
  const int first = map.add(pointSeenBy({{0, 0}, {1, 0}}));
  map.remove(first);
  map.addSighting(first, {1, 3});
  const int second = map.add(pointSeenBy({{0, 1}, {1, 1}}));
  EXPECT_EQ(second, first);
  map.remove(second);
  for (const auto& keyframe : map.keyframes())
    for (const int point : keyframe.points) EXPECT_EQ(point, kNoPoint);
}

TEST(VisualMap, MergesTwoPointsIntoOneWithTheSightingsOfBoth) {
  auto map = twoKeyframes();
  const int kept = map.add(pointSeenBy({{0, 0}}));
  const int merged = map.add(pointSeenBy({{1, 2}}));
  map.merge(kept, merged);
  EXPECT_TRUE(map.point(merged).isGone());
  EXPECT_EQ(map.point(kept).sightings.size(), 2u);
  EXPECT_EQ(map.keyframe(1).points[2], kept);
  EXPECT_EQ(map.countOfPoints(), 1u);
}

TEST(PoseChain, KnowsDistancesAsWellAsOdometryAroundTheKeyframeDoes) {
  auto map = twoKeyframes();
  EXPECT_TRUE(scaleCovariance(map, 0, Pose2(1.0, 0.0, 0.0)).isZero()) << "there is no odometry yet";
  map.keyframe(1).pose = Pose2(0.25, 0.0, 0.0);
  map.keyframe(1).way = map.keyframe(1).pose;
  map.keyframe(1).way_covariance.diagonal() << 9e-5, 1e-5, 4e-4;  // 4e-4 m^2 a metre
  for (const int keyframe : {0, 1}) {
    const Pose2 pose = map.keyframe(keyframe).pose * Pose2(0.0, 0.5, 1.0);
    const auto covariance = scaleCovariance(map, keyframe, pose);
    EXPECT_NEAR(covariance(1, 1), 4.0 * 4e-4 * 0.5, 1e-9) << "four times, along the way";
    EXPECT_NEAR(covariance.trace(), covariance(1, 1), 1e-12);
    EXPECT_TRUE(scaleCovariance(map, keyframe, map.keyframe(keyframe).pose).isZero());
  }
}

}  // namespace
}  // namespace slam::mono_graph
