// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/node_chain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/place_raster.hpp"
#include "slam_core/landmark_graph/sighting_index.hpp"
#include "slam_core/landmark_graph/twist_covariance.hpp"

namespace slam::landmark_graph {
using graph_slam::PlaceRaster;

namespace {

const Pose2 kStep(0.5, 0.1, 0.2);

Motion step() {
  Motion motion;
  motion.increment = kStep;
  motion.covariance = Eigen::Vector3d(1e-4, 2e-4, 1e-5).asDiagonal();
  return motion;
}

/// Five nodes, the first with a prior.
struct Line {
  Line() {
    Pose2 pose;
    graph.add(pose);
    graph.add(std::make_unique<graph::PosePrior>(0, pose, 1e3 * Eigen::Matrix3d::Identity()));
    chain.start(0);
    for (graph::Key key = 1; key < 5; ++key) {
      pose = pose * kStep;
      EXPECT_EQ(graph.add(pose), key);
      chain.append(key - 1, key, step());
    }
    graph.optimize({4}, 5);
  }
  graph::Optimizer graph;
  NodeChain chain{graph};
};

TEST(NodeChain, KeepsWhatIsKnownOfTheEndWhenNodesBetweenGo) {
  Line line;
  const Pose2 end = line.graph.pose(4);
  const Eigen::Matrix3d P = line.graph.covariance({4});
  for (const graph::Key key : {2, 1, 3}) {
    line.chain.remove(key);
    line.graph.optimize({4}, 5);
    EXPECT_LT(line.graph.pose(4).between(end).vector().norm(), 1e-6);
    EXPECT_TRUE(line.graph.covariance({4}).isApprox(P, 1e-3));
  }
  EXPECT_EQ(line.chain.size(), 2u);
  EXPECT_EQ(line.chain[4].before, 0);
  EXPECT_EQ(line.chain[0].after, 4);
}

TEST(NodeChain, LosesANodeAtEitherEnd) {
  Line line;
  line.chain.remove(4);
  EXPECT_EQ(line.chain[3].after, -1);
  line.chain.remove(0);
  EXPECT_EQ(line.chain[1].before, -1);
  EXPECT_EQ(line.chain.size(), 3u);
}

/// A robot drives straight on while its heading wanders by 0.3 rad in all.
TEST(NodeChain, ComposesMotionsThatErrByAsMuchAsTheySay) {
  constexpr int kSteps = 40, kRuns = 400;
  Motion told;
  told.increment = Pose2(0.5, 0.0, 0.0);
  told.covariance = Eigen::Vector3d(1e-6, 1e-6, 0.05 * 0.05).asDiagonal();
  graph::Optimizer graph;
  NodeChain chain(graph);
  graph.add(Pose2());
  chain.start(0);
  for (graph::Key key = 1; key <= kSteps; ++key) {
    graph.add(Pose2(0.5 * key, 0.0, 0.0));
    chain.append(key - 1, key, told);
  }
  for (graph::Key key = 1; key < kSteps; ++key) chain.remove(key);
  graph.add(std::make_unique<graph::PosePrior>(0, Pose2(), 1e6 * Eigen::Matrix3d::Identity()));
  graph.optimize({kSteps}, 5);
  const Pose2 end = graph.pose(kSteps);
  const Eigen::Matrix3d covariance = coordinateCovariance(end, graph.covariance({kSteps}));
  RandomStream random(1, 0);
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    Pose2 truth;
    for (int i = 0; i < kSteps; ++i)
      truth = truth * Pose2(0.5 + 1e-3 * random.gaussian(), 1e-3 * random.gaussian(),
                            0.05 * random.gaussian());
    const Eigen::Vector3d error = truth.vector() - end.vector();
    sum += error.dot(covariance.llt().solve(error));
  }
  EXPECT_LT(sum / kRuns, 4.0) << "3 are expected";
}

TEST(NodeChain, RemovesAChordWithEitherOfItsNodes) {
  const Eigen::Matrix3d W = 1e3 * Eigen::Matrix3d::Identity();
  Line line, plain;
  line.chain.addChord(0, 2, kStep * kStep, W);
  line.chain.addChord(1, 4, kStep * kStep * kStep, W);
  line.graph.optimize({4}, 5);
  const double known = line.graph.covariance({4}).trace();
  EXPECT_LT(known, 0.5 * plain.graph.covariance({4}).trace());
  line.chain.remove(2);
  EXPECT_TRUE(line.chain[0].chords.empty());
  line.graph.optimize({4}, 5);
  EXPECT_GT(line.graph.covariance({4}).trace(), 1.2 * known);
  ASSERT_EQ(line.chain[4].chords.size(), 1u);
  EXPECT_EQ(line.chain[4].chords[0].other, 1);
  line.chain.remove(1);
  EXPECT_TRUE(line.chain[4].chords.empty());
  line.graph.optimize({4}, 5);
  EXPECT_TRUE(line.graph.covariance({4}).isApprox(plain.graph.covariance({4}), 1e-3));
}

TEST(NodeChain, LoosensAMotionAndStillRemovesItsNodes) {
  Line line;
  const Eigen::Matrix3d P = line.graph.covariance({4}), before = line.graph.covariance({3});
  const Eigen::Matrix3d more = Eigen::Vector3d(1e-3, 0.0, 1e-3).asDiagonal();
  line.chain.loosen(4, more);
  line.chain.loosen(0, more);  // no motion leads to it
  line.graph.optimize({4}, 5);
  EXPECT_TRUE(line.graph.covariance({4}).isApprox(P + more, 1e-2));
  EXPECT_TRUE(line.graph.covariance({3}).isApprox(before, 1e-6));
  line.chain.remove(3);
  line.graph.optimize({4}, 5);
  EXPECT_TRUE(line.graph.covariance({4}).isApprox(P + more, 1e-2));
}

/// However far the heading may have wandered, the motion that is left says no more than is known.
TEST(NodeChain, ComposesMotionsOfAnyHeadingWithoutClaimingTooMuch) {
  constexpr int kSteps = 40, kRuns = 300;
  for (const double sigma_of_all : {0.05, 0.3, 1.0, 3.0}) {
    for (const double turn : {0.0, 0.1}) {
      const double sigma = sigma_of_all / std::sqrt(double{kSteps});
      Motion told;
      told.increment = Pose2(0.5, 0.0, turn);
      told.covariance = Eigen::Vector3d(1e-4, 1e-4, sigma * sigma).asDiagonal();
      graph::Optimizer graph;
      NodeChain chain(graph);
      Pose2 pose;
      graph.add(pose);
      chain.start(0);
      for (graph::Key key = 1; key <= kSteps; ++key) {
        graph.add(pose = pose * told.increment);
        chain.append(key - 1, key, told);
      }
      for (graph::Key key = 1; key < kSteps; ++key) chain.remove(key);
      RandomStream random(1, 0);
      double sum = 0.0;
      for (int run = 0; run < kRuns; ++run) {
        Pose2 truth;
        for (int i = 0; i < kSteps; ++i)
          truth =
              truth * told.increment *
              Pose2(1e-2 * random.gaussian(), 1e-2 * random.gaussian(), sigma * random.gaussian());
        visitFactors(graph, [&](const graph::Factor& factor, double) {
          sum += factor.linearized({Pose2(), truth}).r.squaredNorm();
        });
      }
      EXPECT_LT(sum / kRuns, 4.0) << sigma_of_all << " rad, " << turn << "; 3 are expected";
    }
  }
}

TEST(NodeChain, TellsEachNewNodeOnce) {
  Line line;
  EXPECT_EQ(line.chain.takeNew(), (std::vector<graph::Key>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(line.chain.takeNew().empty());
}

TEST(SightingIndex, FindsFactorsByLandmarkAndByNode) {
  SightingIndex index;
  for (int i = 0; i < 3; ++i) index.addLandmark();
  index.addPrior(0, 100);
  index.add(0, 7, 101);
  index.add(1, 7, 102);
  index.add(1, 8, 103);
  EXPECT_EQ(index.count(0), 2u);
  EXPECT_EQ(index.seenFrom(7), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(index.remove(1, 7), 102);
  EXPECT_EQ(index.removeNode(7), (std::vector<graph::FactorId>{101}));
  EXPECT_TRUE(index.seenFrom(7).empty());
  EXPECT_EQ(index.removeLandmark(1), (std::vector<graph::FactorId>{103}));
  EXPECT_TRUE(index.removeNode(8).empty());
  EXPECT_EQ(index.removeLandmark(0), (std::vector<graph::FactorId>{100}));
  EXPECT_EQ(index.count(2), 0u);
}

TEST(PlaceRaster, CountsNodesWithinAMetreAndAnEighthOfATurn) {
  PlaceRaster raster;
  const Pose2 here(-0.5, 3.5, 0.1);
  raster.add(here, 4);
  raster.add(Pose2(-0.9, 3.1, 0.7), 5);
  EXPECT_EQ(raster.count(here), 2u);
  EXPECT_EQ(raster.first(here), 4);
  EXPECT_EQ(raster.first(Pose2(-1.4, 2.9, 0.7)), 5) << "beyond a metre from the other one";
  for (const auto& other : {Pose2(0.6, 3.5, 0.1), Pose2(-0.5, 2.0, 0.1), Pose2(-0.5, 3.5, -0.8),
                            Pose2(-0.5, 3.5, 3.1)}) {
    EXPECT_EQ(raster.count(other), 0u);
    EXPECT_FALSE(raster.first(other));
  }
}

/// Wherever the raster's lines and the end of the circle lie.
TEST(PlaceRaster, CountsTheSameAsWithoutARaster) {
  RandomStream random(3, 0);
  const auto draw = [&] {
    return Pose2(4.0 * random.uniform() - 2.0, 4.0 * random.uniform() - 2.0,
                 2.0 * M_PI * random.uniform());
  };
  PlaceRaster raster;
  std::vector<Pose2> poses;
  for (graph::Key node = 0; node < 300; ++node) {
    poses.push_back(draw());
    raster.add(poses.back(), node);
  }
  for (int i = 0; i < 100; ++i) {
    const Pose2 here = draw();
    const auto near = std::count_if(poses.begin(), poses.end(), [&](const Pose2& each) {
      const Pose2 between = here.between(each);
      return between.position().norm() <= 1.0 && std::abs(between.theta()) <= M_PI / 4;
    });
    EXPECT_EQ(raster.count(here), static_cast<std::size_t>(near));
  }
}

}  // namespace
}  // namespace slam::landmark_graph
