// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/two_views.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "slam_core/common/random.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"

namespace slam::mono_graph {
namespace {

using test::RoomOfPictures;

constexpr double kFocal = 500.0, kPixel = 0.8;  // [px], noise of a feature's place

/// Points ahead of the robot at the origin, each of which looks like no other one.
class Points {
 public:
  Points(std::uint64_t seed, int count) : random_(seed, 0) {
    for (int i = 0; i < count; ++i) {
      const double depth = 1.5 + 4.0 * random_.uniform();
      points_.push_back({{depth, depth * (random_.uniform() - 0.5), 2.0 * random_.uniform()}, {}});
      for (auto& word : points_.back().look)
        word = std::uint64_t{random_.bits()} << 32 | random_.bits();
    }
  }

  /// @param wrong so many look like the point before them
  Features seenFrom(const Pose2& pose, std::size_t wrong = 0) {
    const NormalisedCamera camera(RoomOfPictures::mount());
    std::vector<Feature> features;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto seen = camera.project(pose, points_[i].place);
      if (!seen) continue;
      const Eigen::Vector2d noise(random_.gaussian(), random_.gaussian());
      const auto& look = points_[i > 0 && i <= wrong ? i - 1 : i].look;
      features.push_back({*seen + kPixel / kFocal * noise, Eigen::Vector2d::Zero(), kPixel / kFocal,
                          0.0, 0, look});
    }
    return {std::move(features), camera, kFocal};
  }
  /// Returns what odometry measures of a true motion.
  PosePrior odometryOf(const Pose2& truth, const Eigen::Vector3d& sigmas) {
    const Eigen::Vector3d noise(random_.gaussian(), random_.gaussian(), random_.gaussian());
    return {Pose2::fromVector(truth.vector() + sigmas.cwiseProduct(noise)),
            sigmas.cwiseAbs2().asDiagonal()};
  }

 private:
  struct Point {
    Eigen::Vector3d place;
    Descriptor look;
  };
  RandomStream random_;
  std::vector<Point> points_;
};

TEST(TwoViews, TellTheHeadingToLessThanAPixel) {
  constexpr int kRuns = 200;
  int told = 0;
  double squares = 0.0, of_odometry = 0.0;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    Points points(seed, 150);
    const Pose2 truth(0.25, 0.03, 0.2);
    const auto odometry = points.odometryOf(truth, {0.003, 0.001, 0.05});
    const auto earlier = points.seenFrom({}), later = points.seenFrom(truth);
    const auto motion = motionBetween(earlier, later, odometry);
    if (!motion) continue;
    ++told;
    squares += std::pow(motion->pose.theta() - truth.theta(), 2);
    of_odometry += std::pow(odometry.pose.theta() - truth.theta(), 2);
  }
  EXPECT_GE(told, 195);  // all but those whose odometry errs by more than three sigmas
  EXPECT_LT(std::sqrt(squares / told), 1.0 / kFocal);
  EXPECT_GT(std::sqrt(of_odometry / told), 20.0 / kFocal);
}

TEST(TwoViews, AgreeAlthoughAThirdOfTheirPairsIsWrong) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Points points(seed, 150);
    const Pose2 truth(0.25, 0.03, 0.2);
    const PosePrior odometry{Pose2(0.25, 0.03, 0.3),
                             Eigen::Vector3d(1e-5, 1e-6, 0.0025).asDiagonal()};
    const auto earlier = points.seenFrom({}), later = points.seenFrom(truth, 50);
    const auto motion = motionBetween(earlier, later, odometry);
    ASSERT_TRUE(motion.has_value()) << seed;
    EXPECT_NEAR(motion->pose.theta(), truth.theta(), 4.0 / kFocal) << seed;
  }
}

TEST(TwoViews, MoveThePositionAsOdometryTiesItToTheHeading) {
  Points points(1, 150);
  const Pose2 truth(0.25, 0.03, 0.2);
  Eigen::Matrix3d P = Eigen::Vector3d(1e-5, 1e-4, 0.01).asDiagonal();
  P(1, 2) = P(2, 1) = 0.2 * P(2, 2);  // [m/rad] to the side
  P(1, 1) = 0.2 * P(1, 2) + 1e-6;
  const PosePrior odometry{Pose2(0.25, 0.05, 0.3), P};
  const auto motion = motionBetween(points.seenFrom({}), points.seenFrom(truth), odometry);
  ASSERT_TRUE(motion.has_value());
  EXPECT_NEAR(motion->pose.theta(), truth.theta(), 3.0 / kFocal);
  EXPECT_NEAR(motion->pose.y(), truth.y(), 0.003);
}

TEST(TwoViews, TellTheHeadingOfARobotInARoom) {
  const OrbExtractor orb(500, 0.8);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RoomOfPictures room(seed);
    const Pose2 start(0.0, -1.2, 0.3), truth(0.24, 0.02, 0.15);
    const auto earlier = orb.extract(room.view(Stamp(), start, 640));
    const auto later = orb.extract(room.view(Stamp(), start * truth, 640));
    for (const double off : {-0.12, 0.0, 0.12}) {
      const PosePrior odometry{Pose2(0.24, 0.02, 0.15 + off),
                               Eigen::Vector3d(1e-5, 1e-5, 0.0036).asDiagonal()};
      const auto motion = motionBetween(earlier, later, odometry);
      ASSERT_TRUE(motion.has_value()) << "seed " << seed << ", off by " << off;
      EXPECT_NEAR(motion->pose.theta(), truth.theta(), 3.0 / 544.0) << "seed " << seed;
    }
  }
}

TEST(TwoViews, SayNothingOfScenesThatDifferNorOfTurnsThatOdometryExcludes) {
  const Pose2 truth(0.25, 0.03, 0.2);
  const PosePrior odometry{truth, Eigen::Vector3d(1e-5, 1e-5, 1e-4).asDiagonal()};
  Points points(1, 150), others(2, 150), few(3, 15);
  EXPECT_TRUE(motionBetween(points.seenFrom({}), points.seenFrom(truth), odometry).has_value());
  EXPECT_FALSE(motionBetween(points.seenFrom({}), others.seenFrom(truth), odometry).has_value());
  EXPECT_FALSE(motionBetween(few.seenFrom({}), few.seenFrom(truth), odometry).has_value());
  const Pose2 turned(0.25, 0.03, 0.3);
  EXPECT_FALSE(motionBetween(points.seenFrom({}), points.seenFrom(turned), odometry).has_value());
  const PosePrior still{Pose2(), odometry.covariance};
  EXPECT_FALSE(motionBetween(points.seenFrom({}), points.seenFrom({}), still).has_value());
}

}  // namespace
}  // namespace slam::mono_graph
