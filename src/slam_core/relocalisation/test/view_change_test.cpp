// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/view_change.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/archive_reader.hpp"
#include "slam_core/common/archive_writer.hpp"
#include "slam_core/common/random.hpp"

namespace slam::relocalisation {
namespace {

using Ids = LocalLandmarks::Ids;
using Places = std::vector<Eigen::Vector2d>;

/// Places around a robot, 1 m to 5 m away and no two alike.
Places somePlaces(std::uint64_t seed, int count) {
  RandomStream random(seed, 0);
  Places places;
  for (int i = 0; i < count; ++i) {
    const double range = 1.0 + 4.0 * random.uniform();
    const double bearing = 2.0 * M_PI * (i + 0.8 * random.uniform()) / count;
    places.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  return places;
}

LandmarkObservationArray viewOf(const Places& places, const Pose2& robot = {}) {
  LandmarkObservationArray array;
  for (const auto& place : places) {
    const Eigen::Vector2d p = robot.inverse().transform(place);
    LandmarkObservation z;
    z.range = p.norm();
    z.bearing = std::atan2(p.y(), p.x());
    z.covariance << 1e-4, 0.0, 0.0, 1e-5;
    array.observations.push_back(z);
  }
  return array;
}

Motion motionBy(double way) {
  Motion motion;
  motion.increment = Pose2(way, 0.0, 0.0);
  motion.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal();
  return motion;
}

/// Lets a robot that stands see the same several times. @return the sum of the evidence
double evidenceOf(ViewChange& change, const Places& places, int views) {
  double sum = 0.0;
  for (int i = 0; i < views; ++i) sum += change.judge(viewOf(places), true, Ids::kIgnored);
  return sum;
}

const Places kHere = somePlaces(1, 8), kThere = somePlaces(2, 8);

TEST(ViewChange, IsEvidentSoonAfterTheStart) {
  ViewChange change;
  EXPECT_EQ(evidenceOf(change, kHere, 4), 0.0);
  EXPECT_GT(evidenceOf(change, kThere, 3), 10.0);
}

TEST(ViewChange, CountsOnce) {
  ViewChange change;
  EXPECT_EQ(evidenceOf(change, kHere, 100), 0.0);
  EXPECT_GT(evidenceOf(change, kThere, 3), 15.0);
  EXPECT_EQ(evidenceOf(change, kThere, 100), 0.0);
}

/// Three landmarks that were always seen again suffice.
TEST(ViewChange, IsEvidentByFewLandmarks) {
  ViewChange change;
  EXPECT_EQ(evidenceOf(change, somePlaces(1, 3), 100), 0.0);
  EXPECT_GT(evidenceOf(change, somePlaces(2, 3), 3), 15.0);
}

/// Four landmarks are gone, and two are seen in their place.
TEST(ViewChange, IsEvidentByFewerLandmarksThanBefore) {
  ViewChange change;
  EXPECT_EQ(evidenceOf(change, somePlaces(1, 4), 100), 0.0);
  EXPECT_GT(evidenceOf(change, somePlaces(2, 2), 3), 15.0);
}

TEST(ViewChange, IsEvidentWhileTheRobotDrivesFast) {
  ViewChange change;
  const Places here = somePlaces(1, 8), there = somePlaces(2, 8);
  Pose2 robot;
  double before = 0.0, after = 0.0;
  for (int i = 0; i < 20; ++i) {
    const auto motion = motionBy(0.05);
    change.move(motion);
    robot = robot * motion.increment;
    (i < 10 ? before : after) +=
        change.judge(viewOf(i < 10 ? here : there, robot), true, Ids::kIgnored);
  }
  EXPECT_EQ(before, 0.0);
  EXPECT_GT(after, 10.0);
}

/// The robot drives 0.05 m from view to view. @param told by its odometry [m]
/// @return the sum of the evidence
double evidenceOfDrive(double told) {
  ViewChange change;
  evidenceOf(change, kHere, 20);
  double sum = 0.0;
  for (int i = 1; i <= 10; ++i) {
    change.move(motionBy(told));
    sum += change.judge(viewOf(kHere, Pose2(0.05 * i, 0.0, 0.0)), true, Ids::kIgnored);
  }
  return sum;
}

TEST(ViewChange, LittleByLittleIsEvidentWhereOdometryStands) {
  EXPECT_GT(evidenceOfDrive(0.0), 15.0);
}

/// Odometry stands for some views while the robot drives; it is noticed, and the robot is found.
TEST(ViewChange, OfARobotThatWasLostIsNotLearnt) {
  ViewChange change;
  for (int i = 1; i <= 14; ++i)  // six of them fill the blocks
    change.judge(viewOf(kHere, Pose2(0.05 * i, 0.0, 0.0)), true, Ids::kIgnored);
  change.forgetBefore();
  evidenceOf(change, kHere, 17);  // the first eleven that are judged
  double sum = 0.0;
  for (int i = 1; i <= 10; ++i)
    sum += change.judge(viewOf(kHere, Pose2(0.05 * i, 0.0, 0.0)), true, Ids::kIgnored);
  EXPECT_GT(sum, 15.0);
}

TEST(ViewChange, LittleByLittleIsNoSignWhereOdometryMoves) {
  EXPECT_EQ(evidenceOfDrive(0.05), 0.0);
}

TEST(ViewChange, OfTwoViewsIsNoSign) {
  ViewChange change;
  evidenceOf(change, kHere, 100);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(evidenceOf(change, kThere, 2), 0.0);
    EXPECT_EQ(evidenceOf(change, kHere, 10), 0.0);
  }
}

TEST(ViewChange, ThatIsUsualIsNoSign) {
  ViewChange change;
  for (int i = 0; i < 300; ++i) evidenceOf(change, i % 2 == 0 ? kHere : kThere, 3);
  EXPECT_LT(evidenceOf(change, kHere, 3), 8.0);
}

TEST(ViewChange, IsNotJudgedWhereTheRobotHasMovedFar) {
  ViewChange change;
  evidenceOf(change, kHere, 100);
  for (int i = 0; i < 10; ++i) {
    change.move(motionBy(2.0));
    EXPECT_EQ(change.judge(viewOf(kThere), true, Ids::kIgnored), 0.0);
  }
}

TEST(ViewChange, NeedsSomethingElseInPlaceOfWhatIsGone) {
  ViewChange change;
  evidenceOf(change, kHere, 100);
  EXPECT_EQ(evidenceOf(change, {kHere[0], kHere[1]}, 10), 0.0) << "the others are hidden";
  EXPECT_EQ(evidenceOf(change, kHere, 10), 0.0) << "they are seen again";
}

TEST(ViewChange, IsOfPointsOnly) {
  ViewChange change;
  auto here = viewOf(kHere), there = viewOf(kThere);
  for (auto* const view : {&here, &there})
    for (auto& z : view->observations) z.kind = LandmarkKind::kLine;
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(change.judge(i < 10 ? here : there, true, Ids::kIgnored), 0.0);
}

/// The same places with ids from `first` on.
LandmarkObservationArray withIds(LandmarkObservationArray array, LandmarkId first) {
  for (auto& z : array.observations) z.id = first++;
  return array;
}

double evidenceById(ViewChange& change, const LandmarkObservationArray& array, int views) {
  double sum = 0.0;
  for (int i = 0; i < views; ++i) sum += change.judge(array, true, Ids::kKnown);
  return sum;
}

/// It shows other ids at the same places.
TEST(ViewChange, IsEvidentByTwoIds) {
  ViewChange change;
  const auto places = viewOf({{2.0, 0.5}, {2.0, -0.5}, {3.0, 3.0}, {3.0, -3.0}});
  EXPECT_EQ(evidenceById(change, withIds(places, 1), 200), 0.0);
  EXPECT_GT(evidenceById(change, withIds(places, 11), 3), 15.0);
}

TEST(ViewChange, IsRefutedByAnIdThatStays) {
  ViewChange change;
  auto here = withIds(viewOf(somePlaces(1, 4)), 1), there = withIds(viewOf(somePlaces(1, 4)), 11);
  there.observations[0].id = here.observations[0].id;
  EXPECT_EQ(evidenceById(change, here, 200), 0.0);
  EXPECT_LT(evidenceById(change, there, 10), 12.0);
}

/// A camera that sees a third of a full turn turns past a ring of markers.
TEST(ViewChange, OfIdsAtTheEdgeWhileTheRobotTurnsIsNoSign) {
  ViewChange change;
  double evidence = 0.0;
  Pose2 robot;
  for (int i = 0; i < 500; ++i) {
    Motion motion = motionBy(0.0);
    motion.increment = Pose2(0.0, 0.0, 0.12);
    change.move(motion);
    robot = robot * motion.increment;
    LandmarkObservationArray seen;
    for (auto& z : withIds(viewOf(somePlaces(3, 12), robot), 1).observations)
      if (std::abs(z.bearing) < M_PI / 3.0) seen.observations.push_back(z);
    evidence += change.judge(seen, true, Ids::kKnown);
  }
  EXPECT_EQ(evidence, 0.0);
}

TEST(ViewChange, GoesOnInTheMiddleOfAChange) {
  ViewChange change;
  evidenceOf(change, kHere, 10);
  evidenceOf(change, kThere, 2);
  ArchiveWriter writer;
  writer(change);
  ViewChange resumed;
  const std::string bytes = writer.take();
  ArchiveReader reader(bytes);
  reader(resumed);
  const double evidence = evidenceOf(change, kThere, 1);
  EXPECT_GT(evidence, 10.0);
  EXPECT_EQ(evidenceOf(resumed, kThere, 1), evidence);
}

}  // namespace
}  // namespace slam::relocalisation
