// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"
#include "slam_core/scan_matching/test/matching.hpp"

namespace slam::scan_matching {
namespace {

/// Two walls without ends, a metre to either side, and a laser that sees 5.6 m of them.
class Corridor : public testing::Test {
 protected:
  LaserScan scanAt(const Pose2& pose) {
    constexpr int kBeams = 682;
    constexpr double kFieldOfView = 4.19, kMostRange = 5.6;
    LaserScan scan;
    scan.relative_sigma = 0.01;
    for (int i = 0; i < kBeams; ++i) {
      const double bearing = kFieldOfView * (i / (kBeams - 1.0) - 0.5);
      const double direction = pose.theta() + bearing;
      const double to_wall = std::copysign(1.0, std::sin(direction)) - pose.y();
      const double range =
          to_wall / std::sin(direction) * (1.0 + scan.relative_sigma * random.gaussian());
      const bool hit = range < kMostRange;
      scan.beams.push_back(
          {static_cast<float>(bearing), static_cast<float>(hit ? range : kMostRange), hit});
    }
    return scan;
  }
  ScanLevels pointsAt(const Pose2& pose) { return pointsOf(scanAt(pose), models, kSpacing); }
  void draw(double to) {
    for (double x = 0.0; x < to; x += 0.4) map.insert(pointsAt({x, 0, 0}), {x, 0, 0});
  }

  RandomStream random{1, 0};
  LevelModels models = levelModels({});
  ScanMap map{grid_map::GridMapConfig()};
};

/// Of the line through the ends on one side.
double directionOfWall(const grid_map::ScanPoints& scan, double side) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  int count = 0;
  const auto forWall = [&](const auto& visit) {
    for (const auto& end : scan.ends)
      if (side * end.y() > 0.0 && std::abs(end.x()) < scan.cells_per_metre) visit(end);
  };
  forWall([&](const Eigen::Vector2d& end) { mean += end, ++count; });
  mean /= count;
  Eigen::Vector2d moments = Eigen::Vector2d::Zero();
  forWall([&](const Eigen::Vector2d& end) {
    const Eigen::Vector2d offset = end - mean;
    moments += offset.x() * offset;
  });
  return moments.y() / moments.x();
}

TEST_F(Corridor, EndsThatAreMatchedShowWallsAsTheyStand) {
  constexpr int kScans = 200;
  for (const double side : {-1.0, 1.0}) {
    double mean = 0.0;
    for (int i = 0; i < kScans; ++i) mean += directionOfWall(pointsAt({})[0], side) / kScans;
    EXPECT_NEAR(mean, 0.0, 0.0008) << "three times what chance makes of it";
  }
}

TEST_F(Corridor, AScanDoesNotTellHowFarAlongItIs) {
  draw(4.0);
  double squares = 0.0, along = 0.0, across = 0.0;
  constexpr int kScans = 50;
  const Pose2 prior(2.3, 0.06, 0.04);
  for (int i = 0; i < kScans; ++i) {
    const auto match =
        ScanToMapMatcher().match(map.view(), pointsAt({2.0, 0, 0}), priorAt(prior, 0.02));
    EXPECT_NEAR(match.pose.y(), 0.0, 0.01);
    EXPECT_NEAR(match.pose.theta(), 0.0, 0.005);
    squares += std::pow(match.pose.x() - prior.x(), 2) / kScans;
    along += match.information(0, 0) / kScans;
    across += match.information(1, 1) / kScans;
  }
  EXPECT_LT(std::sqrt(squares), 0.01) << "nothing says that wheels are off";
  EXPECT_GT(across, 1e4) << "a centimetre";
  EXPECT_LT(along, 1e-2 * across);
}

/// A laser that looks ahead has seen the walls from afar, as dots that are further apart than
/// cells. When it stands beside them, they look like posts in the map.
TEST_F(Corridor, DotsOfAWallTellNothingAlongIt) {
  map.insert(pointsAt({-4.0, 0, 0}), {-4.0, 0, 0});
  constexpr int kScans = 40;
  double held = 0.0, information = 0.0;
  for (int i = 0; i < kScans; ++i) {
    const Pose2 truth(-1.5 + 0.04 * i, 0, 0);
    const Pose2 prior(truth.x() + (i % 2 == 0 ? 0.1 : -0.1), 0.0, 0.0);
    const auto match =
        ScanToMapMatcher().matchNearby(map.view(), pointsAt(truth), priorAt(prior, 0.05));
    held += std::abs(match.pose.x() - prior.x()) / kScans;
    information += match.information(0, 0) / kScans;
  }
  EXPECT_LT(held, 0.02);
  EXPECT_LT(information, 6000.0) << "13000 with posts instead of rows";
}

TEST_F(Corridor, ARobotComesBackToOlderWallsWithWhatMotionTellsAlongThem) {
  draw(4.0);
  const Pose2 truth(2.0, 0, 0);
  auto prior = priorAt({2.1, -0.4, 0.0}, 0.02);  // relative to the walls that were drawn last
  prior.information_among_older = priorAt(prior.pose, 0.3).information;
  const auto match = ScanToMapMatcher().match(map.view(), pointsAt(truth), prior);
  EXPECT_TRUE(match.is_among_older);
  EXPECT_NEAR(match.pose.y(), truth.y(), 0.02);
  EXPECT_NEAR(match.pose.x(), prior.pose.x(), 0.1) << "nothing else tells";
}

TEST_F(Corridor, WheelsSayHowFarTheRobotHasGone) {
  ScanTracker tracker;
  RandomStream slips(2, 0);
  double wheels = 0.0;
  InsertionTrigger trigger(0.4, 0.3);
  for (int i = 0; i < 400; ++i) {
    Motion motion;
    motion.increment = Pose2(i == 0 ? 0.0 : 0.08 + 0.002 * slips.gaussian(), 0.0, 0.0);
    motion.covariance = Eigen::Vector3d(4e-6, 4e-6, 1e-6).asDiagonal();
    wheels += motion.increment.x();
    const auto scan = pointsAt({0.08 * i, 0, 0});
    tracker.track(map.view(), scan, Stamp() + i * std::chrono::milliseconds(100), motion);
    if (!trigger.isDue(tracker.robot().pose)) continue;
    trigger.note(tracker.robot().pose);
    map.insert(scan, tracker.robot().pose);
  }
  EXPECT_NEAR(tracker.robot().pose.x(), wheels, 0.3) << "of 32 m";
  EXPECT_NEAR(tracker.robot().pose.theta(), 0.0, 0.02);
}

double sigmaOf(const SlipEstimate& slip, const Pose2& increment, int axis) {
  return std::sqrt(slip.covarianceOf(increment)(axis, axis));
}

TEST(SlipEstimate, DoubtsALongWayMoreThanAShortOne) {
  const SlipEstimate slip;
  EXPECT_NEAR(sigmaOf(slip, Pose2(), 0), 0.02, 1e-9);
  EXPECT_NEAR(sigmaOf(slip, Pose2(1, 0, 0), 0), 0.22, 1e-9);
  EXPECT_NEAR(sigmaOf(slip, Pose2(0, 0, 1), 2), 0.22, 1e-9);
}

TEST(SlipEstimate, LearnsHowGoodWheelsAre) {
  SlipEstimate slip;
  RandomStream random(3, 0);
  const Pose2 increment(0.1, 0, 0);
  for (int i = 0; i < 1000; ++i)
    slip.learn(increment, Pose2(0.008 * random.gaussian(), 0.008 * random.gaussian(), 0.0),
               {1.0, 1.0, 0.0});
  EXPECT_NEAR(sigmaOf(slip, increment, 0), 0.008, 0.002);
  EXPECT_NEAR(sigmaOf(slip, increment, 2), 0.03, 1e-9) << "of heading nothing was told";
}

TEST(SlipEstimate, IsNeverSureOfThemAndNoSlipIsALesson) {
  SlipEstimate slip;
  const Pose2 increment(0.1, 0, 0);
  for (int i = 0; i < 1000; ++i) slip.learn(increment, Pose2(), {1.0, 1.0, 1.0});
  const double least = sigmaOf(slip, increment, 0);
  EXPECT_GT(least, 0.001);
  slip.learn(increment, Pose2(5.0, 0.0, 0.0), {1.0, 1.0, 1.0});
  EXPECT_LT(sigmaOf(slip, increment, 0), 5 * least);
}

}  // namespace
}  // namespace slam::scan_matching
