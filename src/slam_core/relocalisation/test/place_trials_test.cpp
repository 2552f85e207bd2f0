// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/place_trials.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/archive.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::relocalisation {
namespace {

using slam::test::RoomDrive;

constexpr double kOdds = 100.0;
const Pose2 kRight, kWrong(1.5, 0.8, 1.0);  // T_map_local

/// Scans of a robot in the room, whose local frame is the map's, and the map of another drive.
class PlaceTrialsTest : public testing::Test {
 protected:
  void SetUp() override {
    RoomDrive drive(1);
    for (int i = 0; i < RoomDrive::kLap; ++i) {
      const auto step = drive.next();
      map.insert(scan_matching::pointsOf(step.scan, models, 0.02), step.truth);
    }
    next();
  }
  /// The next scan that is kept.
  void next() {
    constexpr int kSteps = 3;
    RoomDrive::Step step;
    for (int i = 0; i < kSteps; ++i) step = robot.next();
    last = {scan_matching::pointsOf(step.scan, models, 0.02), step.truth, 0.0};
  }
  void lead(const Pose2& map_local, PlaceTrials::Prior prior = PlaceTrials::Prior::kNone) {
    trials.lead(foundAt(map_local), last.pose, {last}, prior);
  }
  scan_matching::Match foundAt(const Pose2& map_local) const {
    scan_matching::Match found;
    found.pose = map_local * last.pose;
    return found;
  }
  bool isEnoughFor(const Pose2& map_local) const {
    return trials.isEnoughFor(map_local * last.pose, last.pose);
  }
  void drive(int scans) {
    for (int i = 0; i < scans; ++i) {
      next();
      trials.see(last, map.view(), matcher);
    }
  }
  grid_map::GridMapConfig config;
  scan_matching::LevelModels models = scan_matching::levelModels(config);
  scan_matching::ScanMap map{config};
  scan_matching::ScanToMapMatcher matcher;
  RoomDrive robot{2};
  LocalScan last;
  PlaceTrials trials{kOdds};
};

TEST_F(PlaceTrialsTest, GoOnWithPlacesOnTrialAfterACheckpoint) {
  lead(kRight);
  lead(kWrong);
  drive(2);
  ArchiveWriter writer;
  writer(trials);
  const auto saved = writer.take();
  PlaceTrials resumed(kOdds);
  ArchiveReader reader(saved);
  reader(resumed);
  for (auto* each : {&trials, &resumed}) {
    auto drive = robot;
    for (int i = 0; i < 40; ++i) {
      const auto step = drive.next();
      if (i % 3 != 2) continue;
      last = {scan_matching::pointsOf(step.scan, models, 0.02), step.truth, 0.0};
      each->see(last, map.view(), matcher);
    }
  }
  EXPECT_TRUE(resumed.hasEnough());
  ArchiveWriter first, second;
  first(trials);
  second(resumed);
  EXPECT_TRUE(first.take() == second.take());
}

TEST_F(PlaceTrialsTest, APlaceIsNotBelievedForTheSearchThatLedThere) {
  lead(kRight);
  EXPECT_FALSE(isEnoughFor(kRight));
  EXPECT_FALSE(trials.hasEnough());
}

TEST_F(PlaceTrialsTest, TheRightOneOfTwoPlacesIsToldByLaterScans) {
  lead(kWrong);
  lead(kRight);
  drive(12);
  EXPECT_TRUE(isEnoughFor(kRight));
  EXPECT_FALSE(isEnoughFor(kWrong));
}

/// Else a search that leads elsewhere once would take all evidence away.
TEST_F(PlaceTrialsTest, ASearchThatLeadsElsewhereEndsNoTrial) {
  lead(kRight);
  drive(12);
  lead(kWrong);
  EXPECT_TRUE(isEnoughFor(kRight));
}

TEST_F(PlaceTrialsTest, APlaceThatASearchLeadsToAgainKeepsItsEvidence) {
  lead(kRight);
  drive(12);
  lead(kRight);
  EXPECT_TRUE(isEnoughFor(kRight));
}

/// Among many places one looks like the robot's by chance.
TEST_F(PlaceTrialsTest, TheMorePlacesHaveBeenTriedTheMoreEvidenceIsNeeded) {
  lead(kRight);
  for (int i = 0; i < 12 && !trials.hasEnough(); ++i) drive(1);
  ASSERT_TRUE(trials.hasEnough());
  for (int i = 0; i < 90; ++i) lead(Pose2(3.0 + i, 0.0, 0.0));
  EXPECT_FALSE(trials.hasEnough());
  drive(12);
  EXPECT_TRUE(isEnoughFor(kRight));
}

/// The search has chosen the place all the same, but it is likely to be wrong.
TEST_F(PlaceTrialsTest, APlaceThatTheSearchedScansContradictNeedsMoreEvidence) {
  auto doubtful = trials, clear = trials;
  auto found = foundAt(kRight);
  found.agreement.agreeing = 300;
  clear.lead(found, last.pose, {last}, PlaceTrials::Prior::kNone);
  found.agreement.contradicting = 100;
  doubtful.lead(found, last.pose, {last}, PlaceTrials::Prior::kNone);
  const auto see = [this](PlaceTrials& some) { some.see(last, map.view(), matcher); };
  for (int i = 0; i < 20 && !clear.hasEnough(); ++i) {
    drive(1);
    see(clear);
    see(doubtful);
  }
  ASSERT_TRUE(clear.hasEnough());
  EXPECT_FALSE(doubtful.hasEnough());
  for (int i = 0; i < 20; ++i) {
    drive(1);
    see(doubtful);
  }
  EXPECT_TRUE(doubtful.hasEnough());
}

TEST_F(PlaceTrialsTest, TheExpectedPlaceNeedsNoOtherEvidence) {
  lead(kRight, PlaceTrials::Prior::kExpected);
  EXPECT_TRUE(isEnoughFor(kRight));
}

/// But what comes next may refute it.
TEST_F(PlaceTrialsTest, TheExpectedPlaceIsRefutedByScansThatDoNotFit) {
  lead(kWrong, PlaceTrials::Prior::kExpected);
  drive(12);
  EXPECT_FALSE(isEnoughFor(kWrong));
  lead(kWrong, PlaceTrials::Prior::kExpected);
  EXPECT_FALSE(isEnoughFor(kWrong));
}

/// Scans contradict a map that errs as well, without anybody having carried the robot.
TEST_F(PlaceTrialsTest, APlaceWhereTheRobotCanOnlyHaveBeenCarriedNeedsMoreEvidence) {
  auto rarely = trials;
  trials.lead(foundAt(kRight), last.pose, {last}, PlaceTrials::Prior::kNone);
  rarely.lead(foundAt(kRight), last.pose, {last}, PlaceTrials::Prior::kUnlikely);
  for (int i = 0; i < 20 && !trials.hasEnough(); ++i) {
    drive(1);
    rarely.see(last, map.view(), matcher);
  }
  ASSERT_TRUE(trials.hasEnough());
  EXPECT_FALSE(rarely.hasEnough());
  for (int i = 0; i < 40 && !rarely.hasEnough(); ++i) {
    drive(1);
    rarely.see(last, map.view(), matcher);
  }
  EXPECT_TRUE(rarely.hasEnough());
}

TEST_F(PlaceTrialsTest, OnlyTheBelievedPlaceIsTestedOn) {
  lead(kWrong);
  lead(kRight);
  drive(12);
  trials.keepOnly(kRight * last.pose, last.pose);
  EXPECT_LT((trials.only().placeOf(last.pose).position() - last.pose.position()).norm(), 0.1);
  EXPECT_GT(trials.only().evidence(), 0.0);
}

TEST_F(PlaceTrialsTest, NothingIsLeftOfAForgottenTrial) {
  lead(kRight, PlaceTrials::Prior::kExpected);
  trials.forget();
  EXPECT_FALSE(trials.hasEnough());
  EXPECT_FALSE(isEnoughFor(kRight));
}

}  // namespace
}  // namespace slam::relocalisation
