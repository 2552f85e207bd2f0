// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/optimizer.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/local_map.hpp"

namespace slam::graph {
namespace {

const Eigen::Matrix3d kExact = 1e4 * Eigen::Matrix3d::Identity();

/// A robot that drives twice around a square with noise, with a loop at each place of the second
/// round.
class Square {
 public:
  explicit Square(std::uint64_t seed, const OptimizerLimits& limits = {})
      : optimizer(limits), random_(seed, 0) {
    truth.emplace_back();
    optimizer.add(Pose2());
    optimizer.add(std::make_unique<PosePrior>(0, Pose2(), kExact));
  }
  Pose2 noisy(const Pose2& exact) {
    return exact * Pose2(kSigma * random_.gaussian(), kSigma * random_.gaussian(),
                         kSigma * random_.gaussian());
  }
  void step() {
    const int i = static_cast<int>(truth.size());
    const Pose2 ahead(1, 0, i % 10 == 0 ? M_PI / 2 : 0.0);
    truth.push_back(truth.back() * ahead);
    const Pose2 z = noisy(ahead);
    optimizer.add(optimizer.pose(i - 1) * z);
    optimizer.add(std::make_unique<Between>(i - 1, i, z, weight()));
    if (i >= kRound) {
      const int before = i - kRound;
      const Pose2 relative = truth[static_cast<std::size_t>(before)].between(truth.back());
      optimizer.add(std::make_unique<Between>(before, i, noisy(relative), weight()));
    }
    optimizer.update({i});
  }
  /// Normalised by the marginal covariance.
  double squaredError(Key key) const {
    const Eigen::Vector3d error =
        optimizer.pose(key).between(truth[static_cast<std::size_t>(key)]).log();
    return error.dot(optimizer.covariance({key}).inverse() * error);
  }
  static Eigen::Matrix3d weight() { return Eigen::Matrix3d::Identity() / kSigma; }

  static constexpr int kRound = 40;
  static constexpr double kSigma = 0.02;
  Optimizer optimizer;
  std::vector<Pose2> truth;

 private:
  RandomStream random_;
};

TEST(Optimizer, ComesToTheMinimumStepByStep) {
  Square square(1);
  for (int i = 0; i < 2 * Square::kRound; ++i) square.step();
  const double chi2 = square.optimizer.chi2();
  square.optimizer.optimize({2 * Square::kRound}, 20);
  EXPECT_NEAR(chi2, square.optimizer.chi2(), 1e-3 * chi2);
}

TEST(Optimizer, PassesChangesOnOverManyStepsWhereFewMayBePassedOn) {
  OptimizerLimits limits;
  limits.correction = 0.005;
  limits.change = 0.0;
  Square whole(1, limits);
  limits.passed_on = 1;
  Square slow(1, limits);
  double waits = 0.0, apart = 0.0;
  for (int i = 0; i < 2 * Square::kRound; ++i) {
    slow.step();
    whole.step();
    const auto estimates = settled(slow.optimizer);
    const auto far = [](const Pose2& a, const Pose2& b) { return a.between(b).vector().norm(); };
    for (Key key = 0; key < static_cast<Key>(estimates.size()); ++key) {
      const auto& estimate = estimates[static_cast<std::size_t>(key)];
      waits = std::max(waits, far(slow.optimizer.pose(key), estimate));
      apart = std::max(apart, far(whole.optimizer.pose(key), estimate));
    }
    ASSERT_LT(far(slow.optimizer.pose(i + 1), whole.optimizer.pose(i + 1)), 0.02)
        << "what is new does not wait";
  }
  EXPECT_GT(waits, 0.005);
  EXPECT_LT(apart, 0.25 * waits)
      << "all changes are known, whether or not they have been passed on";
}

TEST(Optimizer, KnowsHowLargeItsErrorsAre) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Square square(seed);
    for (int i = 0; i < 60; ++i) square.step();
    for (const Key key : {20, 40, 60}) {
      sum += square.squaredError(key);
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 3.0, 0.6);  // 180 values of mean 3 and variance 6, some correlated
}

/// What chi2 is at the minimum is known: as many degrees of freedom as there are more rows of
/// factors than of variables.
TEST(Optimizer, LeavesAsMuchErrorAsThereAreLoops) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Square square(seed);
    for (int i = 0; i < 60; ++i) square.step();
    sum += square.optimizer.chi2();
  }
  EXPECT_NEAR(sum / 30, 3.0 * 21, 5.0);
}

TEST(Optimizer, FindsPosesAndPointsFromRangesAndBearings) {
  Optimizer optimizer;
  const std::vector<Eigen::Vector2d> points = {{2, 1}, {3, -1}, {1, 2}};
  const std::vector<Pose2> poses = {Pose2(), Pose2(1, 0.2, 0.3), Pose2(1.8, 0.9, 0.9)};
  const Pose2 sensor(0.1, 0, 0.2);
  RandomStream random(3, 0);
  std::vector<Key> pose_keys, point_keys;
  for (const auto& pose : poses)
    pose_keys.push_back(
        optimizer.add(pose * Pose2(0.05 * random.gaussian(), 0.05 * random.gaussian(), 0.1)));
  for (const auto& point : points)
    point_keys.push_back(optimizer.add(
        Eigen::Vector2d(point + 0.1 * Eigen::Vector2d(random.gaussian(), random.gaussian()))));
  optimizer.add(std::make_unique<PosePrior>(pose_keys[0], poses[0], kExact));
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      const Eigen::Vector2d seen = (poses[i] * sensor).inverse().transform(points[j]);
      optimizer.add(std::make_unique<RangeBearing>(
          pose_keys[i], point_keys[j], sensor,
          Eigen::Vector2d(seen.norm(), std::atan2(seen.y(), seen.x())),
          100 * Eigen::Matrix2d::Identity()));
    }
  EXPECT_TRUE(optimizer.optimize({pose_keys.back()}, 20));
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT(optimizer.pose(pose_keys[i]).between(poses[i]).vector().norm(), 1e-3);
  for (std::size_t j = 0; j < points.size(); ++j)
    EXPECT_LT((optimizer.pose(point_keys[j]).position() - points[j]).norm(), 1e-3);
}

TEST(Optimizer, ForgetsAFactorThatIsRemovedOrWeighsNothing) {
  Square with(5), without(5);
  for (int i = 0; i < 50; ++i) {
    with.step();
    without.step();
  }
  const auto factor = std::make_shared<Between>(3, 30, Pose2(20, 5, 1), Square::weight());
  const auto id = with.optimizer.add(factor);
  with.optimizer.optimize({50}, 20);
  EXPECT_GT(with.optimizer.chi2(*factor), 100.0);
  const double far = with.optimizer.pose(30).between(without.optimizer.pose(30)).vector().norm();
  EXPECT_GT(far, 0.1);
  const auto expectSame = [&] {
    with.optimizer.optimize({50}, 20);
    without.optimizer.optimize({50}, 20);
    for (Key key = 0; key <= 50; ++key)
      EXPECT_LT(with.optimizer.pose(key).between(without.optimizer.pose(key)).vector().norm(),
                1e-4);
  };
  with.optimizer.set(id, 1e-9);
  expectSame();
  with.optimizer.set(id, 1.0);
  with.optimizer.optimize({50}, 20);
  with.optimizer.remove(id);
  expectSame();
}

/// An error of heading of a whole radian at the last loop: the part between turns as a whole.
TEST(Optimizer, TurnsAPartOfTheGraphFarInFewSteps) {
  Optimizer optimizer;
  const Eigen::Matrix3d loose = Eigen::Vector3d(100, 100, 1).asDiagonal();
  optimizer.add(Pose2());
  optimizer.add(std::make_unique<PosePrior>(0, Pose2(), kExact));
  for (int i = 1; i <= 20; ++i) {
    optimizer.add(optimizer.pose(i - 1) * Pose2(1, 0, 0));
    optimizer.add(std::make_unique<Between>(i - 1, i, Pose2(1, 0, 0), i == 1 ? loose : kExact));
    optimizer.update({i});
  }
  const Pose2 end = Pose2(1, 0, 1) * Pose2(19, 0, 0);
  optimizer.add(std::make_unique<PosePrior>(20, end, kExact));
  for (int i = 0; i < 4; ++i) optimizer.update({20});
  for (int i = 1; i <= 20; ++i) {
    const Pose2 expected = Pose2(1, 0, 1) * Pose2(i - 1, 0, 0);
    EXPECT_LT(optimizer.pose(i).between(expected).vector().norm(), 1e-2);
  }
}

/// A factor that is added to a pose which has moved far is linearised at the pose's old origin. The
/// next step moves the origin, so that it has to linearise this factor again.
TEST(Optimizer, LinearisesAgainWhatWasAddedToAPoseThatHasMovedFar) {
  Optimizer optimizer;
  optimizer.add(Pose2());
  optimizer.add(std::make_unique<PosePrior>(0, Pose2(), Eigen::Matrix3d::Identity()));
  optimizer.update({0});
  optimizer.add(std::make_unique<PosePrior>(0, Pose2(3, -2, 0.5), kExact));
  EXPECT_TRUE(optimizer.update({0})) << "it has moved too far for its factors";
  const Pose2 ahead(1, 0, 0.2);
  optimizer.add(optimizer.pose(0) * ahead);
  optimizer.add(std::make_unique<Between>(0, 1, ahead, kExact));
  optimizer.update({1});
  EXPECT_LT(optimizer.pose(0).between(optimizer.pose(1)).between(ahead).vector().norm(), 1e-6);
  EXPECT_LT(optimizer.pose(0).between(Pose2(3, -2, 0.5)).vector().norm(), 1e-3);
}

/// Turns a triangle of points by priors. @return whether the next step would linearise it again
bool isDueAfterATurn(double angle, double patience) {
  OptimizerLimits limits;
  limits.patience = patience;
  Optimizer optimizer(limits);
  LocalMap map;
  map.points = {{-1, 0}, {1, 0}, {0, 1}};
  map.covariance = 1e-2 * Eigen::MatrixXd::Identity(6, 6);
  std::vector<Key> keys;
  for (const auto& point : map.points) keys.push_back(optimizer.add(point));
  const auto triangle = optimizer.add(std::make_shared<FreeMap>(keys, map));
  const Eigen::Matrix2d W = 1e4 * Eigen::Matrix2d::Identity();
  for (std::size_t i = 0; i < keys.size(); ++i)
    optimizer.add(
        std::make_shared<PointPrior>(keys[i], Pose2(0, 0, angle).transform(map.points[i]), W));
  const bool is_due = optimizer.update({keys.back()});
  EXPECT_FALSE(optimizer.update({keys.back()}, {keys, {}})) << "what waited is linearised again";
  optimizer.remove(triangle);
  optimizer.add(
      std::make_shared<PointPrior>(keys[0], Pose2(0, 0, angle).transform(map.points[0]), W));
  EXPECT_FALSE(optimizer.update({keys.back()}, {keys, {}})) << "no factor waits that is gone";
  return is_due;
}

TEST(Optimizer, LetsALocalMapWaitThatHasTurnedALittle) {
  EXPECT_FALSE(isDueAfterATurn(0.01, 1.0));
  EXPECT_TRUE(isDueAfterATurn(0.04, 1.0));
  EXPECT_FALSE(isDueAfterATurn(0.04, 3.0));
  EXPECT_TRUE(isDueAfterATurn(0.1, 3.0));
}

/// Points far from where they began: factors that are linearised at different times have the same
/// minimum as those that are linearised together.
TEST(Optimizer, CarriesPointsAlongWhereALocalMapIsDragged) {
  Optimizer optimizer;
  LocalMap map;
  std::vector<Key> keys;
  for (const auto& point : {Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 0), Eigen::Vector2d(1, 3)}) {
    map.points.push_back(point);
    keys.push_back(optimizer.add(point));
  }
  map.covariance = 1e-4 * Eigen::MatrixXd::Identity(6, 6);
  optimizer.add(std::make_shared<FreeMap>(keys, map));
  const Eigen::Matrix2d W = 10.0 * Eigen::Matrix2d::Identity();
  const Pose2 dragged(5, -3, 0.4);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    optimizer.add(std::make_shared<PointPrior>(keys[i], dragged.transform(map.points[i]), W));
    for (int k = 0; k < 8; ++k) optimizer.update({keys.back()});
  }
  for (std::size_t i = 0; i < keys.size(); ++i)
    EXPECT_LT((optimizer.pose(keys[i]).position() - dragged.transform(map.points[i])).norm(), 5e-3);
  EXPECT_LT(optimizer.chi2(), 1e-2);
}

}  // namespace
}  // namespace slam::graph
