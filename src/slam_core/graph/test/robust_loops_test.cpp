// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/robust_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/graph/factors.hpp"

namespace slam::graph {
namespace {

constexpr double kSigma = 0.05;  // of odometry and loops [m, rad]

/// A robot that drives round and round a square of 10 m.
class RobustLoopsTest : public testing::Test {
 protected:
  void SetUp() override {
    truth.emplace_back();
    graph.add(Pose2());
    graph.add(std::make_shared<PosePrior>(0, Pose2(), 1e4 * Eigen::Matrix3d::Identity()));
  }
  static Eigen::Matrix3d weight() { return Eigen::Matrix3d::Identity() / kSigma; }
  Pose2 noisy(const Pose2& exact) {
    const double s = kSigma * noise;
    return exact * Pose2(s * random.gaussian(), s * random.gaussian(), s * random.gaussian());
  }
  int newest() const { return static_cast<int>(truth.size()) - 1; }
  void settle() {
    for (int i = 0; i < 10 && graph.update({newest()}); ++i) continue;
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      const Pose2 ahead(1, 0, (newest() + 1) % 10 == 0 ? M_PI / 2 : 0.0);
      const Pose2 z = noisy(ahead);
      truth.push_back(truth.back() * ahead);
      graph.add(graph.pose(newest() - 1) * z);
      graph.add(std::make_shared<Between>(newest() - 1, newest(), z, weight()));
      settle();
    }
  }
  bool add(int a, int b, const Pose2& z) {
    const bool is_believed = loops.add(std::make_shared<Between>(a, b, z, weight()));
    loops.judge([this] { settle(); });
    return is_believed;
  }
  bool addTrue(int a, int b) {
    return add(a, b, noisy(truth[std::size_t(a)].between(truth[std::size_t(b)])));
  }
  double error() const {
    double sum = 0.0;
    for (int i = 0; i <= newest(); ++i)
      sum += (graph.pose(i).position() - truth[std::size_t(i)].position()).squaredNorm();
    return std::sqrt(sum / (newest() + 1));
  }

  double noise = 1.0;  ///< of what is measured, relative to what is told
  RandomStream random{11, 0};
  std::vector<Pose2> truth;
  Optimizer graph;
  RobustLoops loops{graph, RobustLoops::Noise::kAsTold};
};

/// The graph's doubt of where the robot is after 40 m is far larger than the loops' noise.
TEST_F(RobustLoopsTest, BelievesALoopThatMovesMuchWhenAnotherSaysTheSame) {
  drive(40);
  const double before = error();
  EXPECT_FALSE(addTrue(0, 40));
  drive(1);
  EXPECT_TRUE(addTrue(1, 41));
  EXPECT_EQ(loops.rejected(), 0u);
  EXPECT_LT(error(), before);
}

TEST_F(RobustLoopsTest, AFalseLoopConfirmsNone) {
  drive(40);
  addTrue(0, 40);
  EXPECT_FALSE(add(5, 38, truth[5].between(truth[38]) * Pose2(1.5, 0.5, 0.2)));
  EXPECT_EQ(loops.rejected(), 2u);
}

TEST_F(RobustLoopsTest, BelievesALoneLoopThatManyLaterOnesDoNotContradict) {
  drive(40);
  addTrue(0, 40);
  drive(1);
  for (int i = 0; i < 110; ++i) addTrue(39, 41);
  EXPECT_TRUE(loops.isBelieved(0));
}

TEST_F(RobustLoopsTest, AFalseLoopWaitsAndMovesNothing) {
  drive(41);
  addTrue(0, 40);
  addTrue(1, 41);
  const Pose2 before = graph.pose(25);
  EXPECT_FALSE(add(5, 25, Pose2()));
  EXPECT_EQ(loops.rejected(), 1u);
  EXPECT_FALSE(loops.isBelieved(2));
  EXPECT_LT(before.between(graph.pose(25)).vector().norm(), 1e-3);
  EXPECT_EQ(loops.changes().believed, 2u);
  EXPECT_EQ(loops.changes().taken_back, 0u);
  std::vector<bool> counts;
  for (const auto& loop : loops.states()) counts.push_back(loop.is_believed);
  EXPECT_EQ(counts, (std::vector<bool>{true, true, false}));
}

/// On the first round nothing contradicts two false loops that are off by what odometry may be.
TEST_F(RobustLoopsTest, TakesBackLoopsThatTheGraphComesToContradict) {
  drive(31);
  const Pose2 wrong(1.0, 0.0, 0.0);
  const Pose2 last = graph.pose(30).between(graph.pose(31));
  const Pose2 z = graph.pose(0).between(graph.pose(30)) * wrong;
  add(0, 30, z);
  add(0, 31, z * last);
  ASSERT_TRUE(loops.isBelieved(0));
  for (const int i : {10, 20, 30, 31})
    graph.add(std::make_shared<Between>(0, i, truth[std::size_t(i)], 10.0 * weight()));
  settle();
  addTrue(0, 30);
  EXPECT_FALSE(loops.isBelieved(0));
  EXPECT_TRUE(loops.isBelieved(2));
  EXPECT_LT(error(), 0.2);
}

TEST_F(RobustLoopsTest, LetsInALoopThatWaitsWhenTheGraphComesToAgree) {
  drive(41);
  addTrue(0, 40);
  addTrue(1, 41);
  const Pose2 wrong = graph.pose(10).between(graph.pose(20)) * Pose2(0.0, 1.0, 0.3);
  ASSERT_FALSE(add(10, 20, wrong));
  graph.add(std::make_shared<Between>(10, 20, wrong, 100.0 * weight()));
  for (int i = 0; i < 20; ++i) settle();
  addTrue(40, 41);
  EXPECT_TRUE(loops.isBelieved(2));
}

/// Where errors are a fifth of what is told, a loop that is off by what would be usual is false.
TEST_F(RobustLoopsTest, LearnsHowNoisyLoopsAreIfAsked) {
  noise = 0.2;
  RobustLoops learning(graph, RobustLoops::Noise::kLearnt);
  drive(120);
  for (int i = 0; i < 80; ++i) {
    const Pose2 z = noisy(truth[std::size_t(i)].between(truth[std::size_t(i) + 40]));
    for (auto* each : {&loops, &learning}) {
      each->add(std::make_shared<Between>(i, i + 40, z, weight()));
      each->judge([this] { settle(); });
    }
  }
  const auto off = std::make_shared<Between>(
      30, 110, truth[30].between(truth[110]) * Pose2(0.15, 0.0, 0.0), weight());  // 3 sigmas
  EXPECT_FALSE(learning.add(off));
  EXPECT_TRUE(loops.add(off));
}

/// Two false loops pass the gates as long as errors are thought to be five times as large.
TEST_F(RobustLoopsTest, JudgesTheFirstLoopsAnewOnceTheNoiseIsLearnt) {
  noise = 0.2;
  RobustLoops learning(graph, RobustLoops::Noise::kLearnt);
  const auto add_to_learning = [&](int a, int b, const Pose2& z) {
    learning.add(std::make_shared<Between>(a, b, z, weight()));
    learning.judge([this] { settle(); });
  };
  drive(11);
  const Pose2 z = truth[0].between(truth[10]) * Pose2(0.9, 0.0, 0.0);
  add_to_learning(0, 10, z);
  add_to_learning(0, 11, z * truth[10].between(truth[11]));
  ASSERT_EQ(learning.rejected(), 0u);
  drive(160);
  for (int i = 12; i < 130; ++i) {
    const Pose2 exact = truth[std::size_t(i)].between(truth[std::size_t(i) + 40]);
    add_to_learning(i, i + 40, noisy(exact));
  }
  EXPECT_FALSE(learning.isBelieved(0));
  EXPECT_FALSE(learning.isBelieved(1));
  EXPECT_EQ(learning.rejected(), 2u);
  EXPECT_EQ(learning.changes().taken_back, 2u);
  EXPECT_EQ(learning.changes().believed, 120u);
}

}  // namespace
}  // namespace slam::graph
