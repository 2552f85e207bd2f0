// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/observation_intake.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

constexpr std::size_t kMost = ObservationIntake::kMostObservations;
constexpr std::size_t kMostNew = ObservationIntake::kMostNewLandmarks;

LandmarkObservation observationOf(LandmarkId id) {
  LandmarkObservation z;
  z.id = id;
  z.range = 2.0;
  z.covariance = 0.01 * Eigen::Matrix2d::Identity();
  return z;
}

LandmarkObservationArray arrayOf(LandmarkId first, std::size_t count) {
  LandmarkObservationArray array;
  for (LandmarkId id = first; id < first + static_cast<LandmarkId>(count); ++id)
    array.observations.push_back(observationOf(id));
  return array;
}

class ObservationIntakeTest : public testing::Test {
 protected:
  ObservationIntake intake;
  Counters counters;
};

TEST_F(ObservationIntakeTest, LetsAllOfAnOrdinaryArrayThrough) {
  auto array = arrayOf(0, kMostNew);
  EXPECT_EQ(intake.screen(array, counters), "");
  EXPECT_EQ(intake.admit(array, counters), "");
  EXPECT_EQ(array.observations.size(), kMostNew);
  EXPECT_TRUE(counters.all().empty());
}

/// ./slam run writes such corrections into a robot file that it has calibrated.
TEST_F(ObservationIntakeTest, CorrectsWhatTheRobotFileSaysOfTheSensor) {
  LandmarkSensorConfig sensor;
  sensor.range_scale = 1.5;
  sensor.mount_x = 0.1;
  sensor.mount_yaw = -0.2;
  sensor.time_offset = 0.25;
  auto array = arrayOf(0, 1);
  array.stamp = stampFromNanoseconds(1'000'000'000);
  array.sensor_pose = Pose2(0.3, 0.0, 0.5);
  EXPECT_EQ(ObservationIntake(sensor).screen(array, counters), "");
  EXPECT_NEAR(array.observations[0].range, 3.0, 1e-12);
  EXPECT_NEAR(array.observations[0].covariance(0, 0), 0.0225, 1e-12);
  EXPECT_NEAR(array.observations[0].covariance(1, 1), 0.01, 1e-12);
  EXPECT_NEAR(array.sensor_pose.x(), 0.4, 1e-12);
  EXPECT_NEAR(array.sensor_pose.theta(), 0.3, 1e-12);
  EXPECT_EQ(array.stamp, stampFromNanoseconds(1'250'000'000));
}

TEST_F(ObservationIntakeTest, SaysOnceThatNoObservationHasAnId) {
  const auto warningsOf = [this](ObservationIntake screened, LandmarkId id) {
    int warnings = 0;
    for (int i = 0; i < 100; ++i) {
      LandmarkObservationArray array;
      array.observations = {observationOf(kUnknownId)};
      if (i == 5) array.observations.push_back(observationOf(id));
      const auto told = screened.screen(array, counters);
      warnings += test::oneSays({told}, {"no observation so far has an id", "association=jcbb"});
    }
    return warnings;
  };
  EXPECT_EQ(warningsOf(ObservationIntake({}, false, true), kUnknownId), 1);
  EXPECT_EQ(warningsOf(ObservationIntake({}, false, true), 3), 0);
  EXPECT_EQ(warningsOf(ObservationIntake({}, false, false), kUnknownId), 0);
}

TEST_F(ObservationIntakeTest, CutsAnArrayThatIsTooLargeAndSaysSo) {
  auto array = arrayOf(0, 100000);
  EXPECT_TRUE(test::oneSays({intake.screen(array, counters)}, {"100000", "500", "left out"}));
  EXPECT_EQ(array.observations.size(), kMost);
  EXPECT_EQ(counters["observations_beyond_limit"], 100000 - kMost);
}

TEST_F(ObservationIntakeTest, LeavesOutADescriptorThatCannotBeUsedAndNothingElse) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  auto array = arrayOf(1, 4);
  auto& all = array.observations;
  all[0].descriptor = descriptorOf(0.2, 0.01);
  all[1].descriptor = descriptorOf(kNan, 0.01);
  EXPECT_EQ(intake.screen(array, counters),
            "observation of landmark 2 has a descriptor that holds a value that is not a number; "
            "the descriptor is left out");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].descriptor.size(), 1);
  EXPECT_TRUE(all[1].descriptor.isEmpty());
  all[2].descriptor = descriptorOf(0.2, -0.01);
  EXPECT_EQ(intake.screen(array, counters),
            "observation of landmark 3 has a descriptor with a sigma that is not positive; the "
            "descriptor is left out");
  EXPECT_EQ(counters["invalid_descriptor"], 2u);
  EXPECT_EQ(counters["invalid_observation"], 0u);
}

TEST_F(ObservationIntakeTest, LeavesOutADescriptorOfAnotherLengthThanThoseBefore) {
  auto array = arrayOf(1, 1);
  array.observations[0].descriptor = descriptorOf(0.2, 0.01);
  EXPECT_EQ(intake.screen(array, counters), "");
  auto next = arrayOf(2, 1);
  const Descriptor::Vector two = Descriptor::Vector::Constant(2, 0.1F);
  next.observations[0].descriptor = {two, two};
  EXPECT_EQ(intake.screen(next, counters),
            "observation of landmark 2 has a descriptor of 2 elements and those before had 1; the "
            "descriptor is left out");
  EXPECT_EQ(next.observations.size(), 1u);
  intake.knowOnly({});
  next.observations[0].descriptor = {two, two};
  EXPECT_EQ(intake.screen(next, counters), "") << "after a reset another detector may come";
}

TEST_F(ObservationIntakeTest, LeavesOutThoseWithoutAnIdBeforeOthers) {
  auto array = arrayOf(0, kMost - 10);
  array.observations.insert(array.observations.end(), 30, observationOf(kUnknownId));
  intake.screen(array, counters);
  ASSERT_EQ(array.observations.size(), kMost);
  const auto unknown = std::count_if(array.observations.begin(), array.observations.end(),
                                     [](const auto& z) { return z.id == kUnknownId; });
  EXPECT_EQ(unknown, 10);
  array = arrayOf(0, kMost + 10);
  array.observations.push_back(observationOf(kUnknownId));
  intake.screen(array, counters);
  ASSERT_EQ(array.observations.size(), kMost);
  EXPECT_EQ(array.observations.front().id, 0);
}

TEST_F(ObservationIntakeTest, AddsSoManyLandmarksInAStepAndTheOthersLater) {
  auto array = arrayOf(0, kMostNew + 50);
  EXPECT_TRUE(test::oneSays({intake.admit(array, counters)}, {"250 new landmarks", "200"}));
  EXPECT_EQ(array.observations.size(), kMostNew);
  EXPECT_EQ(counters["new_landmarks_beyond_limit"], 50u);
  array = arrayOf(0, kMostNew + 50);
  EXPECT_EQ(intake.admit(array, counters), "");
  EXPECT_EQ(array.observations.size(), kMostNew + 50);
}

TEST_F(ObservationIntakeTest, LeavesOutLinesOfABackendThatMapsPoints) {
  auto array = arrayOf(0, 3);
  array.observations[1].kind = LandmarkKind::kLine;
  array.observations[1].extent = {-1.0, 1.0};
  auto same = array;
  EXPECT_TRUE(
      test::oneSays({intake.screen(array, counters)}, {"lines are left out", "backend=ekf"}));
  EXPECT_EQ(array.observations.size(), 2u);
  EXPECT_EQ(counters["line_observation"], 1u);
  EXPECT_EQ(ObservationIntake({}, true).screen(same, counters), "");
  EXPECT_EQ(same.observations.size(), 3u);
}

TEST_F(ObservationIntakeTest, CountsNoLandmarkOfTheMapAsNew) {
  LandmarkMap map(kMost);
  for (std::size_t i = 0; i < map.size(); ++i) map[i].id = static_cast<LandmarkId>(i);
  intake.knowOnly(map);
  auto array = arrayOf(0, kMost);
  EXPECT_EQ(intake.admit(array, counters), "");
  EXPECT_EQ(array.observations.size(), kMost);
  intake.knowOnly({});
  EXPECT_NE(intake.admit(array, counters), "");
  EXPECT_EQ(array.observations.size(), kMostNew);
}

}  // namespace
}  // namespace slam
