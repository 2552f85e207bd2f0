// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"

// Maps in which no robot can be searched for: the pose that comes with them is believed, and a
// warning says so.

namespace slam {
namespace {

constexpr const char* kBelieved = "its pose is believed as it is";

void configure(Estimator& estimator, const std::string& backend,
               const std::vector<std::string>& overrides) {
  Settings settings({}, {}, overrides);
  estimator.use(Registry<Backend>::instance().create(backend));
  estimator.configure(settings);
}

bool warns(const Status& status, const std::string& words) {
  return status.level == Status::Level::kWarning && status.message.find(words) != std::string::npos;
}

/// Four landmarks of one kind around the robot.
MapState mapOf(LandmarkKind kind) {
  MapState map;
  map.robot.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  for (int id = 0; id < 4; ++id) {
    Landmark landmark;
    landmark.id = id;
    landmark.kind = kind;
    landmark.direction = M_PI / 2 * id;
    landmark.position = 3.0 * Eigen::Rotation2Dd(landmark.direction).matrix().col(0);
    landmark.covariance = 1e-4 * Eigen::Matrix2d::Identity();
    if (landmark.isLine()) landmark.extent = {-2.0, 2.0};
    map.landmarks.push_back(landmark);
  }
  return map;
}

/// The robot at the origin of mapOf() sees one of its lines.
LandmarkObservationArray linesAhead(Stamp stamp, std::uint64_t sequence) {
  LandmarkObservationArray array;
  array.stamp = stamp;
  array.sequence = sequence;
  LandmarkObservation z;
  z.kind = LandmarkKind::kLine;
  z.range = 3.0;
  z.extent = {-1.0, 1.0};
  z.covariance = 1e-4 * Eigen::Matrix2d::Identity();
  array.observations = {z};
  return array;
}

TEST(UnsearchedMap, OfAGridThatIsTooLargeIsTold) {
  Estimator estimator;
  configure(estimator, "grid", {"map=grid"});
  MapState map;
  map.grid.emplace();
  map.grid->resolution = 2.0;
  map.grid->width = map.grid->height = 300;
  map.grid->cells.assign(300 * 300, 0);
  EXPECT_TRUE(warns(estimator.set(map), "more than 500 m"));
}

TEST(UnsearchedMap, OfLinesIsTold) {
  Estimator estimator;
  configure(estimator, "ekf", {"association=jcbb"});
  EXPECT_TRUE(warns(estimator.set(mapOf(LandmarkKind::kLine)), kBelieved));
  EXPECT_TRUE(estimator.set(mapOf(LandmarkKind::kPoint)).isOk());
  EXPECT_TRUE(estimator.set(MapState()).isOk()) << "an empty map is where a robot begins";
}

TEST(UnsearchedMap, OfPointsIsNotWaitedForByARobotThatSeesLinesOnly) {
  Estimator estimator;
  configure(estimator, "ekf", {"association=jcbb"});
  ASSERT_TRUE(estimator.set(mapOf(LandmarkKind::kPoint)).isOk());
  const auto begin = stampFromNanoseconds(1000000000);
  bool is_told = false;
  for (int i = 0; i < 20; ++i) {
    Motion motion;
    motion.sequence = static_cast<std::uint64_t>(i);
    motion.start = begin + i * std::chrono::milliseconds(100);
    motion.end = motion.start + std::chrono::milliseconds(100);
    motion.covariance = 1e-8 * Eigen::Matrix3d::Identity();
    estimator.set(motion);
    estimator.set(linesAhead(motion.end, motion.sequence));
    is_told = warns(estimator.execute(), kBelieved) || is_told;
  }
  EXPECT_TRUE(is_told);
  EXPECT_EQ(estimator.counters()["withheld"], 0u);
}

}  // namespace
}  // namespace slam
