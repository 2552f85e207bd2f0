// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/landmark_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <functional>

#include "slam_core/models/test/simulated_world.hpp"

namespace slam {
namespace {

/// Changes what the sensors of the simulated world have measured.
using Miscalibration = std::function<void(Motion&, LandmarkObservationArray&)>;

void measureAll(Motion&, LandmarkObservationArray&) {}

/// All pieces of a way of `metres`.
std::vector<PieceOfWay> piecesOf(const Miscalibration& off, double metres = 20.0,
                                 std::uint64_t seed = 1) {
  test::SimulatedWorld world(seed);
  LandmarkMotion landmarks;
  std::vector<PieceOfWay> pieces;
  for (int i = 0; i < static_cast<int>(metres / 0.2); ++i) {
    auto [motion, seen, truth] = world.next();
    off(motion, seen);
    landmarks.predict(motion);
    if (const auto piece = landmarks.see(seen)) pieces.push_back(*piece);
  }
  return pieces;
}

ScaleDoubt::Difference differenceOf(const std::vector<PieceOfWay>& pieces) {
  ScaleDoubt doubt;
  for (const auto& piece : pieces) doubt.add(piece);
  return doubt.beyondNoise();
}

void turn(LandmarkObservationArray& seen, double angle) {
  for (auto& z : seen.observations) z.bearing += angle;
}

TEST(LandmarkMotion, DiffersFromTheOdometryByNoMoreThanNoise) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto pieces = piecesOf(measureAll, 30.0, seed);
    EXPECT_GT(pieces.size(), 20u);
    for (const auto& [odometry, estimated, covariance] : pieces) {
      const Eigen::Vector2d apart = estimated - odometry;
      sum += apart.dot(covariance.inverse() * apart);
      count += 2;
    }
    EXPECT_EQ(differenceOf(pieces).scale, 0.0) << seed;
    EXPECT_EQ(differenceOf(pieces).turn, 0.0) << seed;
  }
  EXPECT_NEAR(sum / count, 1.0, 0.2) << "the covariance is that of the difference";
}

TEST(LandmarkMotion, ShowsASensorThatIsMountedOtherwiseThanConfiguredWithinThreeMetres) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const double yaw : {0.1, -0.1, 0.3}) {
      const auto pieces = piecesOf([yaw](auto&, auto& seen) { turn(seen, yaw); }, 3.2, seed);
      EXPECT_NEAR(differenceOf(pieces).turn, yaw, 0.05) << seed;
    }
}

/// On a circle wheels that measure more than was driven also turn too far, which moves the end of
/// each piece sideways. That is no sensor that is mounted otherwise.
TEST(LandmarkMotion, ShowsAWrongScaleOfWheelsOrRangesAndNoTurn) {
  for (const double scale : {0.7, 1.3}) {
    const auto of_wheels = differenceOf(piecesOf([scale](auto& motion, auto&) {
      motion.increment = Pose2::exp(scale * motion.increment.log());
      motion.covariance *= scale * scale;
    }));
    EXPECT_NEAR(of_wheels.scale, 1.0 / scale - 1.0, 0.03);
    EXPECT_EQ(of_wheels.turn, 0.0);
    const auto of_ranges = differenceOf(piecesOf([scale](auto&, auto& seen) {
      for (auto& z : seen.observations) z.range *= scale;
    }));
    EXPECT_NEAR(of_ranges.scale, scale - 1.0, 0.03);
  }
}

TEST(LandmarkMotion, IsLeftOutWhereIdsAreFalse) {
  RandomStream random(1, 0);
  const auto pieces = piecesOf([&random](auto&, auto& seen) {
    auto& all = seen.observations;
    for (auto& z : all)
      if (random.uniform() < 0.5) std::swap(z.id, all[random.bits() % all.size()].id);
  });
  EXPECT_TRUE(pieces.empty()) << pieces.size();
}

TEST(LandmarkMotion, NeedsIdsAndPoints) {
  EXPECT_TRUE(piecesOf([](auto&, auto& seen) {
                for (auto& z : seen.observations) z.id = kUnknownId;
              }).empty());
  EXPECT_TRUE(piecesOf([](auto&, auto& seen) {
                for (auto& z : seen.observations) z.kind = LandmarkKind::kLine;
              }).empty());
}

/// The robot is carried, or its wheels slip: neither sensor has another scale.
TEST(LandmarkMotion, OfARobotThatIsCarriedIsNoScale) {
  test::SimulatedWorld world(1);
  LandmarkMotion landmarks;
  for (int i = 0; i < 60; ++i) {
    const auto [motion, seen, truth] = world.next();
    const bool is_carried = i >= 20 && i < 40;
    if (!is_carried) landmarks.predict(motion);
    const auto piece = is_carried ? std::nullopt : landmarks.see(seen);
    if (piece) {
      EXPECT_LT((piece->estimated - piece->odometry).norm(), 0.3) << i;
    }
  }
}

}  // namespace
}  // namespace slam
