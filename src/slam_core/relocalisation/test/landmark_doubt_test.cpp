// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/landmark_doubt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::relocalisation {
namespace {

/// A robot that drives straight on between landmarks, two per metre, and sees those that are less
/// than 4 m ahead or behind. Observations that it associates with its map have the map's ids.
class LandmarkDoubtTest : public testing::Test {
 protected:
  /// One step. @param from the place that the robot really sees [m]
  void step(double from) {
    UpdateStatistics statistics;
    LandmarkObservationArray array;
    for (int i = 0; i < 400; ++i) {
      const double place = 0.5 * i;
      if (std::abs(place - from) > 4.0 || random.uniform() > detected) continue;
      const bool is_mapped = std::abs(place - believed) <= 4.0;
      const auto taken = is_mapped ? TakenFor::kLandmark : TakenFor::kNew;
      statistics.associations.push_back({kUnknownId, i, taken});
      array.observations.push_back(observationOf({place - from, 3.0 * std::sin(100.0 * i)}));
    }
    doubt.see(array);
    doubt.judge(statistics, {believed, 0.0, 0.0}, stamp += std::chrono::milliseconds(100));
    believed += length;
    doubt.move(motionBy(length));
  }
  static LandmarkObservation observationOf(const Eigen::Vector2d& place) {
    LandmarkObservation z;
    z.range = place.norm();
    z.bearing = std::atan2(place.y(), place.x());
    z.covariance << 1e-4, 0.0, 0.0, 1e-5;
    return z;
  }
  static Motion motionBy(double way) {
    Motion motion;
    motion.increment = Pose2(way, 0.0, 0.0);
    motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    return motion;
  }
  /// @return whether it counts as lost within a way [m]
  bool drive(double way, double carried = 0.0) {
    for (const double end = believed + way; believed < end && !doubt.isLost();)
      step(believed + carried);
    return doubt.isLost();
  }

  LandmarkDoubt doubt;
  RandomStream random{1, 1};
  double believed = 0.0, detected = 0.8;
  double length = 0.2;  // of a step [m]
  Stamp stamp = stampFromNanoseconds(1000000000000);
};

TEST_F(LandmarkDoubtTest, NeverDoubtsARobotThatIsRight) {
  for (int lap = 0; lap < 50; ++lap) {
    believed = 0.0;
    ASSERT_FALSE(drive(60.0)) << "lap " << lap;
  }
}

TEST_F(LandmarkDoubtTest, NoticesARobotThatWasCarriedAway) {
  drive(60.0);
  believed = 0.0;
  doubt.relocate();
  ASSERT_FALSE(drive(20.0));
  EXPECT_TRUE(drive(5.0, 60.0));
}

/// Where it believes to be it has never been, so that no landmark is expected there.
TEST_F(LandmarkDoubtTest, NoticesAtOnceThatAllIsAnotherViewOfGroundThatIsNew) {
  length = 0.02;
  ASSERT_FALSE(drive(60.0));
  EXPECT_TRUE(drive(0.1, 60.0));
}

TEST_F(LandmarkDoubtTest, TwoImagesThatShowSomethingElseAreNoSign) {
  length = 0.02;
  ASSERT_FALSE(drive(60.0));
  for (int i = 0; i < 20; ++i) {
    step(believed + 60.0);
    step(believed + 60.0);
    ASSERT_FALSE(drive(2.0));
  }
}

TEST_F(LandmarkDoubtTest, AViewThatChangesWhileTheRobotDrivesOnIsNoSign) {
  length = 0.02;
  ASSERT_FALSE(drive(60.0));
  believed += 10.0;  // the camera has delivered nothing meanwhile
  doubt.move(motionBy(10.0));
  EXPECT_FALSE(drive(20.0));
}

TEST_F(LandmarkDoubtTest, AViewThatIsHiddenAtOnceIsNoSign) {
  length = 0.02;
  ASSERT_FALSE(drive(60.0));
  detected = 0.1;
  EXPECT_FALSE(drive(1.0));
}

TEST_F(LandmarkDoubtTest, DoesNotTrustWhatALostRobotHasBegun) {
  drive(30.0);
  believed = 10.0;
  ASSERT_TRUE(drive(5.0, 60.0));
  EXPECT_TRUE(doubt.isTrusted(20));
  EXPECT_FALSE(doubt.isTrusted(140));
}

/// Whoever explores leaves the landmarks behind that were seen before the doubt began, and would
/// not trust any of those that came since.
TEST_F(LandmarkDoubtTest, TrustsWhatWasMappedLongAfterAViewHasChanged) {
  UpdateStatistics statistics;
  statistics.associations = {{kUnknownId, 0, TakenFor::kLandmark}};
  const auto look = [&](LandmarkId id, std::uint64_t seed, int count) {
    LandmarkObservationArray array;
    RandomStream places(seed, 1);
    for (int i = 0; i < count; ++i)
      array.observations.push_back(
          observationOf({1.0 + 4.0 * places.uniform(), 4.0 * places.uniform() - 2.0}));
    statistics.associations[0].landmark = id;
    doubt.see(array);
    doubt.judge(statistics, {believed, 0.0, 0.0}, stamp += std::chrono::milliseconds(100));
  };
  for (int i = 0; i < 100; ++i) look(1, 1, 2);
  for (int i = 0; i < 3; ++i) look(2, 2, 2);
  for (int i = 0; i < 3; ++i) look(3, 2, 2);
  ASSERT_FALSE(doubt.isLost());
  EXPECT_FALSE(doubt.isTrusted(3));
  for (int i = 0; i < 300; ++i) {
    believed += 0.4;
    doubt.move(motionBy(0.4));
    look(4 + i, 4, 0);
  }
  EXPECT_FALSE(doubt.isLost());
  EXPECT_TRUE(doubt.isTrusted(3));
  EXPECT_TRUE(doubt.isTrusted(300));
}

TEST_F(LandmarkDoubtTest, ExpectsNothingWhereTheRobotHasNeverBeen) {
  drive(20.0);
  believed = 100.0;
  EXPECT_FALSE(drive(40.0, -60.0));
}

TEST_F(LandmarkDoubtTest, KnowsThatLandmarksMayBeHidden) {
  drive(60.0);
  believed = 0.0;
  doubt.relocate();
  detected = 0.1;  // somebody stands in front of the sensor; the few landmarks still seen fit
  EXPECT_FALSE(drive(60.0));
}

/// The only expected landmark has been moved.
TEST_F(LandmarkDoubtTest, DoesNotTakeARobotForLostSinceOneLandmarkIsMissing) {
  UpdateStatistics before, after;
  before.associations = {{kUnknownId, 1, TakenFor::kLandmark}};
  after.associations = {{kUnknownId, 2, TakenFor::kNew}};
  const auto look = [&](const UpdateStatistics& statistics) {
    doubt.judge(statistics, {}, stamp += std::chrono::seconds(1));
  };
  for (int i = 0; i < 20; ++i) look(before);
  for (int i = 0; i < 1000; ++i) look(after);
  EXPECT_FALSE(doubt.isLost());
}

TEST_F(LandmarkDoubtTest, SaysNothingOfObservationsThatAreKnownByTheirIds) {
  UpdateStatistics statistics;
  statistics.innovations.resize(3);
  for (int i = 0; i < 1000; ++i)
    doubt.judge(statistics, {0.2 * i, 0.0, 0.0}, stamp += std::chrono::milliseconds(100));
  EXPECT_FALSE(doubt.isLost());
}

}  // namespace
}  // namespace slam::relocalisation
