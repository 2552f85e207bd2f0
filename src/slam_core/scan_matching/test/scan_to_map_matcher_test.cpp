// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/scan_matching/test/matching.hpp"

namespace slam::scan_matching {
namespace {

using test::RoomDrive;

const auto kModels = levelModels({});

/// A map of the room from known poses, and a scan that is not in it.
class MatchingInARoom : public testing::Test {
 protected:
  MatchingInARoom() {
    for (int i = 0; i < RoomDrive::kLap; ++i) {
      const auto step = drive.next();
      map.insert(pointsOf(step.scan, kModels, kSpacing), step.truth);
    }
    take(drive.next());
  }

  void take(const RoomDrive::Step& step) {
    scan = step.scan;
    truth = step.truth;
  }
  Match matched(const PosePrior& prior) const {
    return matcher.match(map.view(), pointsOf(scan, kModels, kSpacing), prior);
  }
  void expectTruth(const Pose2& found) const {
    const Pose2 error = truth.between(found);
    EXPECT_LT(error.position().norm(), 0.015);
    EXPECT_LT(std::abs(error.theta()), 0.006);
  }

  RoomDrive drive{3};
  ScanMap map{grid_map::GridMapConfig()};
  ScanToMapMatcher matcher;
  LaserScan scan;
  Pose2 truth;
};

TEST_F(MatchingInARoom, TellsWhichEndsFitWhichSurfaces) {
  const auto points = pointsOf(scan, kModels, kSpacing);
  const auto& ends = points[0].ends;
  const auto fitted = matcher.fittedEnds(map.view(), points, truth);
  EXPECT_GT(fitted.size(), ends.size() / 2);
  EXPECT_LE(fitted.size(), ends.size());
  const double cells = points[0].cells_per_metre;
  for (const auto& [surface, information] : fitted) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& end : ends)
      nearest = std::min(nearest, (truth.transform(end / cells) - surface).norm());
    EXPECT_LT(nearest, 0.15);
    EXPECT_GT(information.trace(), 0.0);
    EXPECT_TRUE(information.isApprox(information.transpose()));
  }
}

TEST_F(MatchingInARoom, FindsBackFromWhatOdometryErrsBy) {
  for (const auto& offset : {Pose2(), Pose2(0.08, 0.05, 0.04), Pose2(-0.1, -0.1, -0.1)}) {
    const auto match = matched(priorAt(truth * offset, 0.2));
    EXPECT_TRUE(match.is_determined);
    EXPECT_LT(match.agreement.contradictingShare(), 0.1);
    expectTruth(match.pose);
  }
}

TEST_F(MatchingInARoom, FindsBackAfterASlipOfTheWheels) {
  for (const auto& slip : {Pose2(0.3, 0.0, 0.3), Pose2(-0.2, 0.3, -0.3), Pose2(0.0, -0.3, 0.3)})
    expectTruth(matched(priorAt(truth * slip, 0.05)).pose);
}

TEST_F(MatchingInARoom, FindsBackAfterWheelsThatStoodStillWhileTheRobotMoved) {
  const auto match = matched(priorAt(truth * Pose2(0.9, 0.3, -1.5), 0.05));
  EXPECT_TRUE(match.was_searched);
  expectTruth(match.pose);
}

/// A loop comes back to walls that were drawn long ago. Some things have moved since.
TEST_F(MatchingInARoom, MeetsOlderSurfacesAsFarAwayAsTheMapHasDrifted) {
  for (std::size_t i = 0; i < scan.beams.size(); i += 6) scan.beams[i].range *= 0.6F;
  auto prior = priorAt(truth * Pose2(2.6, -1.2, 0.05), 0.02);
  prior.information_among_older = priorAt(prior.pose, 0.3).information;
  EXPECT_FALSE(matched(prior).is_among_older) << "it has not drifted so far";
  prior.information_among_older = priorAt(prior.pose, 2.0).information;
  const auto match = matched(prior);
  EXPECT_TRUE(match.is_among_older);
  EXPECT_TRUE(match.jumped) << "a wide window's find is no usual one";
  EXPECT_LT(truth.between(match.pose).position().norm(), 0.03);
}

TEST_F(MatchingInARoom, SearchesAsFarAsTheMapHasDriftedEachTime) {
  constexpr bool kMayUseWideWindow = false;
  const auto points = pointsOf(scan, kModels, kSpacing);
  auto prior = priorAt(truth * Pose2(1.1, -0.4, 0.05), 0.02);
  for (const double drift : {0.3, 1.5}) {
    prior.information_among_older = priorAt(prior.pose, drift).information;
    const auto match = matcher.match(map.view(), points, prior, kMayUseWideWindow);
    EXPECT_EQ(match.is_among_older, drift > 1.0);
    if (match.is_among_older) expectTruth(match.pose);
  }
}

TEST(InformationLeft, IsLessInTheDirectionOfTheContradictionAlone) {
  PosePrior prior;
  prior.information << 400.0, 100.0, 20.0, 100.0, 300.0, -30.0, 20.0, -30.0, 900.0;
  const Pose2 found(0.1, -0.2, 0.3);
  const Eigen::Vector3d e = found.vector();
  constexpr double kWeight = 0.25;
  const auto left = informationLeft(prior, found, kWeight);
  EXPECT_NEAR(e.dot(left * e), kWeight * e.dot(prior.information * e), 1e-9);
  const Eigen::Matrix3d more = left.inverse() - prior.information.inverse();  // covariance
  EXPECT_NEAR((more - more.trace() / e.squaredNorm() * e * e.transpose()).norm(), 0.0, 1e-9);
  EXPECT_TRUE(informationLeft(prior, prior.pose, 1.0).isApprox(prior.information));
}

/// Carried from anywhere to anywhere in the room, mostly out of reach of any window.
TEST_F(MatchingInARoom, WithoutOdometrySearchesAsFarAsTheGuessMayBeOff) {
  constexpr bool kMayUseWideWindow = false;
  for (const auto& way : {Pose2(1.0, 0.2, 0.3), Pose2(-0.3, -0.9, -0.6)}) {
    auto guess = priorAt(truth * way.inverse(), 1.0);
    guess.is_measured = false;
    const auto match =
        matcher.match(map.view(), pointsOf(scan, kModels, kSpacing), guess, kMayUseWideWindow);
    EXPECT_TRUE(match.was_searched);
    expectTruth(match.pose);
  }
}

TEST_F(MatchingInARoom, ARobotCarriedAwayHardlyEverFitsAPlaceThatLooksAlike) {
  std::vector<RoomDrive::Step> steps;
  for (int i = 0; i < RoomDrive::kLap; ++i) steps.push_back(drive.next());
  int sure = 0, wrong = 0;
  for (std::size_t from = 0; from < steps.size(); from += 5)
    for (std::size_t to = 0; to < steps.size(); to += 5) {
      take(steps[to]);
      const auto match = matched(priorAt(steps[from].truth, 0.05));
      if (matcher.isDoubtful(match)) continue;
      ++sure;
      wrong += truth.between(match.pose).position().norm() > 0.3;
    }
  EXPECT_GT(sure, 100) << "near enough to where it was";
  EXPECT_LT(wrong, 10) << "of 841; 17 where a jump does not have to beat its rivals";
}

TEST_F(MatchingInARoom, ErrsByAsMuchAsItSays) {
  double squares = 0.0;
  constexpr int kScans = 100;
  RandomStream random(4, 0);
  for (int i = 0; i < kScans; ++i) {
    take(drive.next());
    const Pose2 offset(0.05 * random.gaussian(), 0.05 * random.gaussian(),
                       0.03 * random.gaussian());
    const auto match = matched({truth * offset});
    Eigen::Vector3d error = match.pose.vector() - truth.vector();
    error.z() = wrapAngle(error.z());
    squares += error.dot(match.information * error) / kScans;
  }
  EXPECT_GT(squares, 0.2);  // 3 is expected of errors that are exactly as large as told
  EXPECT_LT(squares, 4.2);
}

TEST_F(MatchingInARoom, PeopleAroundTheRobotDoNotMoveIt) {
  RandomStream random(5, 0);
  for (auto& beam : scan.beams)
    if (random.uniform() < 0.3) beam.range *= static_cast<float>(0.2 + 0.5 * random.uniform());
  const auto match = matched(priorAt(truth * Pose2(0.05, 0.05, 0.03), 0.1));
  expectTruth(match.pose);
}

TEST_F(MatchingInARoom, AScanThatTellsNothingStaysWhereMotionHasIt) {
  const auto prior = priorAt(truth * Pose2(0.05, 0.0, 0.02), 0.1);
  for (const std::size_t beams : {0, 1, 3}) {
    scan.beams.resize(beams);
    const auto match = matched(prior);
    EXPECT_FALSE(match.is_determined);
    EXPECT_LT(prior.pose.between(match.pose).position().norm(), 1e-9);
  }
}

TEST_F(MatchingInARoom, APoseThatIsNoPlaceOnAMapIsLeftAlone) {
  for (const double x : {1e12, std::numeric_limits<double>::quiet_NaN()}) {
    const auto match = matched(priorAt(Pose2(x, 0.0, 0.0), 0.1));
    EXPECT_FALSE(match.is_determined);
  }
}

TEST_F(MatchingInARoom, ATenThousandBeamsAreMatchedAsWell) {
  const auto few = scan.beams;
  scan.beams.clear();
  for (std::size_t i = 0; i + 1 < few.size(); ++i)
    for (int k = 0; k < 56; ++k) scan.beams.push_back(few[i]);
  expectTruth(matched(priorAt(truth * Pose2(0.05, 0.05, 0.03), 0.1)).pose);
}

}  // namespace
}  // namespace slam::scan_matching
