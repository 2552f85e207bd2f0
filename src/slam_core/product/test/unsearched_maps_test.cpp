// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

// Maps in which no robot can be searched for: the pose that comes with them is believed, and a
// warning says so. A robot that gets lost in one is reported to be anywhere in it.

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
  map.grid->width = 300;
  map.grid->height = 10;
  map.grid->cells.assign(300 * 10, 0);
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

class UnsearchedRobot : public testing::Test {
 protected:
  void SetUp() override { configure(estimator, "ekf", {"relocalisation.enabled=false"}); }
  void take(const test::SimulatedStep& step) {
    estimator.set(step.motion);
    estimator.set(step.observations);
    for (auto of_step = estimator.execute(); estimator.report(); of_step = estimator.execute()) {
      status = of_step;
      report = *estimator.report();
    }
    truth = step.truth;
  }

  Estimator estimator;
  StepReport report;
  Status status;  ///< of the last step
  Pose2 truth;
};

TEST_F(UnsearchedRobot, IsReportedLostWithACovarianceThatCoversTheMap) {
  for (const std::uint64_t seed : {3, 9, 14}) {
    SetUp();
    test::SimulatedWorld world(seed);
    for (int i = 0; i < 80; ++i) take(world.next());
    EXPECT_EQ(report.trust, Trust::kConfident);
    auto carried = world.next();
    carried.motion.increment = carried.motion.increment * Pose2(2.0, 1.0, 0.7);
    take(carried);
    for (int i = 0; i < 30; ++i) take(world.next());
    EXPECT_EQ(report.trust, Trust::kLost) << "seed " << seed;
    EXPECT_GT(std::sqrt(report.pose.covariance(0, 0)), 3.0);
    EXPECT_NE(status.message.find("relocalisation.enabled is false"), std::string::npos)
        << status.message;
  }
}

TEST_F(UnsearchedRobot, IsBelievedAgainWhereItIsPut) {
  test::SimulatedWorld world(9);
  for (int i = 0; i < 80; ++i) take(world.next());
  auto carried = world.next();
  carried.motion.increment = carried.motion.increment * Pose2(2.0, 1.0, 0.7);
  take(carried);
  for (int i = 0; i < 30; ++i) take(world.next());
  ASSERT_EQ(report.trust, Trust::kLost);
  const Eigen::Matrix3d P = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
  ASSERT_TRUE(estimator.set(PoseEstimate{truth, P}).isOk());
  for (int i = 0; i < 30; ++i) take(world.next());
  EXPECT_NE(report.trust, Trust::kLost) << report.doubt;
  EXPECT_LT(std::sqrt(report.pose.covariance(0, 0)), 0.5);
}

}  // namespace
}  // namespace slam
