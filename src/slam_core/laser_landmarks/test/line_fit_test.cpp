// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/line_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/laser_landmarks/test/simulated_walls.hpp"

namespace slam::laser_landmarks {
namespace {

using test::SimulatedWall;
using test::WallLaser;

std::vector<LaserBeam> beamsOn(const SimulatedWall& wall, const WallLaser& laser,
                               RandomStream& random) {
  std::vector<LaserBeam> beams;
  for (const auto& beam : scanOfWalls({wall}, Pose2(), laser, random).beams)
    if (beam.hit) beams.push_back(beam);
  return beams;
}

const BeamNoise kNoise{0.02, 0.0, 0.002};

TEST(LineFit, FindsTheLineThatBeamsEndOn) {
  RandomStream random(1, 0);
  const auto line = fitLine(beamsOn({{-1, 2}, {3, 2}}, {}, random), kNoise);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->range, 2.0, 1e-6);
  EXPECT_NEAR(line->bearing, M_PI / 2, 1e-6);
  EXPECT_NEAR(line->extent.begin, -3.0, 0.1) << "to the right of who looks at it";
  EXPECT_NEAR(line->extent.end, 1.0, 0.1);
}

TEST(LineFit, IsAsWrongAsItSays) {
  RandomStream random(2, 0);
  for (const auto& wall :
       {SimulatedWall{{-1, 2}, {3, 2}}, {{4, -1}, {3, 2}}, {{1, 0.5}, {6, 0.7}}}) {
    const Eigen::Vector2d way = (wall.to - wall.from).normalized();
    const auto truth = fitLine(beamsOn(wall, {}, random), kNoise);
    ASSERT_TRUE(truth);
    EXPECT_NEAR(truth->normal().dot(way), 0.0, 1e-6);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double nees = 0.0, misfit = 0.0;
    constexpr int kTimes = 1000;
    for (int i = 0; i < kTimes; ++i) {
      const auto line = fitLine(beamsOn(wall, {0.02, 0.002}, random), kNoise);
      ASSERT_TRUE(line);
      const Eigen::Vector2d error(line->range - truth->range,
                                  wrapAngle(line->bearing - truth->bearing));
      sum += error;
      nees += error.dot(line->covariance.inverse() * error);
      misfit += line->misfit;
    }
    EXPECT_NEAR(nees / kTimes, 2.0, 0.4);
    EXPECT_NEAR(misfit / kTimes, 0.0, 0.3);
    EXPECT_LT(std::abs(sum.x() / kTimes), 0.2 * std::sqrt(truth->covariance(0, 0)));
  }
}

TEST(LineFit, ALongLineTellsItsDirectionBetter) {
  RandomStream random(3, 0);
  const auto of = [&](double half) {
    return fitLine(beamsOn({{2, -half}, {2, half}}, {}, random), kNoise)->covariance;
  };
  EXPECT_LT(of(2.0)(1, 1), 0.2 * of(1.0)(1, 1));
}

TEST(LineFit, NothingStraightIsAMisfit) {
  std::vector<LaserBeam> circle;
  for (int i = 0; i < 40; ++i)
    circle.push_back({static_cast<float>(0.02 * i), i < 20 ? 2.0f : 2.3f, true});
  EXPECT_GT(fitLine(circle, kNoise)->misfit, 5.0);
}

TEST(LineFit, NeedsThreeBeamsThatEndApart) {
  const std::vector<LaserBeam> two = {{0.0f, 2.0f, true}, {0.1f, 2.0f, true}};
  EXPECT_FALSE(fitLine(two, kNoise));
  EXPECT_FALSE(fitLine(std::vector<LaserBeam>(5, {0.1f, 2.0f, true}), kNoise));
}

TEST(LineFit, TwoLinesCrossAtAPointThatIsAsWrongAsTheyAre) {
  RandomStream random(4, 0);
  double nees = 0.0;
  constexpr int kTimes = 1000;
  for (int i = 0; i < kTimes; ++i) {
    const auto a = fitLine(beamsOn({{3, -2}, {3, 1}}, {0.02, 0.002}, random), kNoise);
    const auto b = fitLine(beamsOn({{3, 1}, {-2, 2}}, {0.02, 0.002}, random), kNoise);
    const auto crossing = crossingOf(*a, *b);
    ASSERT_TRUE(crossing);
    const Eigen::Vector2d error = crossing->position - Eigen::Vector2d(3, 1);
    ASSERT_LT(error.norm(), 0.1);
    nees += error.dot(crossing->covariance.inverse() * error);
  }
  EXPECT_NEAR(nees / kTimes, 2.0, 0.4);
  const auto a = fitLine(beamsOn({{3, -2}, {3, 1}}, {}, random), kNoise);
  EXPECT_FALSE(crossingOf(*a, *a)) << "parallel";
}

}  // namespace
}  // namespace slam::laser_landmarks
