// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/cylinder_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "slam_core/laser_landmarks/scan_segments.hpp"
#include "slam_core/laser_landmarks/test/simulated_trees.hpp"

namespace slam::laser_landmarks {
namespace {

using test::Tree;
using test::TreeLaser;

constexpr double kSpacing = M_PI / 360.0;

Tree treeAt(double range, double bearing, double radius) {
  return {{range * std::cos(bearing), range * std::sin(bearing)}, radius};
}

std::optional<Cylinder> seen(const Tree& tree, const TreeLaser& laser, RandomStream& random) {
  const auto found = segmentsOf(scanOfTrees({tree}, Pose2(), laser, random).beams, 0.6, 0.0);
  if (found.segments.size() != 1) return std::nullopt;
  return fitCylinder(found.segments[0].beams, found.spacing,
                     {std::max(laser.sigma_range, 1e-3), 0.0, laser.sigma_bearing});
}

TEST(CylinderFit, FindsTheAxisOfACylinder) {
  RandomStream random(1, 0);
  for (const double range : {2.0, 5.0, 12.0})
    for (const double radius : {0.22, 0.4}) {
      const auto trunk = seen(treeAt(range, 0.3, radius), TreeLaser(), random);
      ASSERT_TRUE(trunk) << range << " " << radius;
      EXPECT_NEAR(trunk->range, range, 0.03);
      EXPECT_NEAR(trunk->bearing, 0.3, kSpacing / 2.0);
      EXPECT_NEAR(trunk->radius, radius, range * kSpacing / 2.0);
    }
}

TEST(CylinderFit, TheWidthTellsTheRadiusOfManyBeams) {
  RandomStream random(1, 0);
  const auto scan = scanOfTrees({treeAt(3.0, 0.0, 0.5)}, Pose2(), TreeLaser(), random);
  const auto found = segmentsOf(scan.beams, 0.6, 0.0);
  const auto trunk = cylinderOfWidth(found.segments.at(0).beams, found.spacing);
  EXPECT_NEAR(trunk.radius, 0.5, 0.02);
  EXPECT_NEAR(trunk.range, 3.0, 0.02);
}

/// Trunks near and far, thin and thick, on beams and between them; only one beam hits the far ones.
class CylinderFitErrors : public testing::TestWithParam<std::tuple<TreeLaser, double>> {};

TEST_P(CylinderFitErrors, AreAsLargeAsItsCovarianceSays) {
  const auto [laser, nearest] = GetParam();
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t run = 0; run < 4000; ++run) {
    RandomStream random(5, run);
    const double range = nearest + 22.0 * random.uniform(), bearing = 2.0 * random.uniform() - 1.0;
    const auto tree = treeAt(range, bearing, 0.1 + 0.5 * random.uniform());
    const auto trunk = seen(tree, laser, random);
    if (!trunk || trunk->misfit > 3.3) continue;
    const Eigen::Vector2d error(trunk->range - range, trunk->bearing - bearing);
    sum += error.dot(trunk->covariance.inverse() * error);
    ++count;
  }
  ASSERT_GT(count, 2000);
  // 2 is expected; the errors of the edges are uniform, not normal.
  EXPECT_LT(sum / count, 2.5) << "the covariance claims too much";
  EXPECT_GT(sum / count, 1.7) << "the covariance claims too little";
}

INSTANTIATE_TEST_SUITE_P(
    Lasers, CylinderFitErrors,
    testing::Combine(testing::Values(TreeLaser{0.01, 0.001}, TreeLaser{0.05, 0.003},
                                     TreeLaser{0.1, 0.001}, TreeLaser{0.02, 0.004}),
                     testing::Values(3.0, 25.0, 45.0)));

TEST(CylinderFit, AFlatBoardIsNoCircle) {
  std::vector<LaserBeam> board;
  for (int i = -20; i <= 20; ++i) {
    const double bearing = i * kSpacing;
    board.push_back(
        {static_cast<float>(bearing), static_cast<float>(3.0 / std::cos(bearing)), true});
  }
  const auto circle = fitCylinder(board, kSpacing, {0.02, 0.0, 0.001});
  EXPECT_TRUE(!circle || circle->misfit > 3.3);
}

TEST(CylinderFit, RangesThatAreOffByMoreThanTheirSigmaAreAMisfit) {
  RandomStream random(3, 0);
  const auto scan = scanOfTrees({treeAt(4.0, 0.0, 0.4)}, Pose2(), TreeLaser{0.01, 0.001}, random);
  auto found = segmentsOf(scan.beams, 0.6, 0.0);
  auto& beams = found.segments.at(0).beams;
  EXPECT_LT(fitCylinder(beams, found.spacing, {0.01, 0.0, 0.001})->misfit, 3.3);
  for (std::size_t i = 0; i < beams.size(); i += 2) beams[i].range += 0.2f;
  const auto circle = fitCylinder(beams, found.spacing, {0.01, 0.0, 0.001});
  EXPECT_TRUE(!circle || circle->misfit > 3.3);
}

}  // namespace
}  // namespace slam::laser_landmarks
