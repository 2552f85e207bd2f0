// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/expected_landmarks.hpp"

#include <gtest/gtest.h>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

enum class Made { kOfMarkers, kOfTrunks };

/// Three points; trunks have their radius as descriptor.
LandmarkMap mapOf(Made made) {
  LandmarkMap map;
  for (int id = 0; id < 3; ++id) {
    Landmark landmark;
    landmark.id = id;
    landmark.position = {2.0 + id, 1.0 * id * id};
    landmark.covariance = 1e-4 * Eigen::Matrix2d::Identity();
    if (made == Made::kOfTrunks)
      landmark.descriptor = {Eigen::VectorXf::Constant(1, 0.2F),
                             Eigen::VectorXf::Constant(1, 0.01F)};
    map.push_back(landmark);
  }
  return map;
}

ExpectedLandmarks expectedOf(const std::string& detector) {
  ProductConfig product;
  product.detector = detector;
  return ExpectedLandmarks(product);
}

bool warns(const Status& status, const std::string& words) {
  return status.level == Status::Level::kWarning && status.message.find(words) != std::string::npos;
}

/// What happens when a robot with this detector loads a map.
Status loaded(const std::string& detector, const std::string& association, Made made) {
  Settings settings({}, {}, {"detector=" + detector, "association=" + association});
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  MapState map;
  map.robot.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  map.landmarks = mapOf(made);
  return estimator.set(map);
}

TEST(ExpectedLandmarks, AMapOfTrunksIsToldToARobotThatSeesMarkers) {
  const auto status = loaded("apriltag", "known_ids", Made::kOfTrunks);
  EXPECT_TRUE(warns(status,
                    "all landmarks of the loaded map have a descriptor, and none that the detector "
                    "'apriltag' finds: if another detector has made the map, load a map"))
      << status.message;
}

TEST(ExpectedLandmarks, AMapOfMarkersIsToldToARobotThatSeesTrunks) {
  const auto status = loaded("laser_trunks", "jcbb", Made::kOfMarkers);
  EXPECT_TRUE(warns(status,
                    "no landmark of the loaded map has a descriptor, and each that the detector "
                    "'laser_trunks' finds: if another detector has made the map, load a map"))
      << status.message;
}

TEST(ExpectedLandmarks, AMapOfTheSameDetectorIsLoadedWithoutAWord) {
  EXPECT_TRUE(loaded("apriltag", "known_ids", Made::kOfMarkers).isOk());
  EXPECT_TRUE(loaded("laser_trunks", "jcbb", Made::kOfTrunks).isOk());
}

/// A map that several detectors have made, or a surveyor has completed.
TEST(ExpectedLandmarks, ALandmarkThatFitsIsEnough) {
  auto map = mapOf(Made::kOfTrunks);
  map.front().descriptor = {};
  EXPECT_TRUE(expectedOf("apriltag").judge(map).isOk());
  EXPECT_TRUE(expectedOf("laser_trunks").judge(map).isOk());
}

TEST(ExpectedLandmarks, NothingIsExpectedOfObservationsFromOutside) {
  for (const auto made : {Made::kOfMarkers, Made::kOfTrunks}) {
    EXPECT_TRUE(expectedOf("none").judge(mapOf(made)).isOk());
    EXPECT_TRUE(expectedOf("of_another_process").judge(mapOf(made)).isOk());
  }
}

TEST(ExpectedLandmarks, AnEmptyMapAndOneOfLinesAreNotJudged) {
  auto lines = mapOf(Made::kOfMarkers);
  for (auto& landmark : lines) landmark.kind = LandmarkKind::kLine;
  EXPECT_TRUE(expectedOf("laser_trunks").judge(lines).isOk());
  EXPECT_TRUE(expectedOf("laser_trunks").judge({}).isOk());
}

}  // namespace
}  // namespace slam
