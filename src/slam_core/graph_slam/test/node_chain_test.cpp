// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/node_chain.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/place_raster.hpp"
#include "slam_core/graph_slam/sighting_index.hpp"

namespace slam::graph_slam {
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
  EXPECT_TRUE(line.chain[4].link.is_composed);
  EXPECT_NEAR(line.chain[4].link.way, 4 * kStep.position().norm(), 1e-9);
}

TEST(NodeChain, LosesANodeAtItsEndAndALinkThatIsCut) {
  Line line;
  line.chain.remove(4);
  EXPECT_EQ(line.chain[3].after, -1);
  line.chain.cut(2);
  EXPECT_EQ(line.chain[2].before, -1);
  EXPECT_EQ(line.chain[1].after, -1);
  line.chain.remove(2);
  EXPECT_EQ(line.chain[3].before, -1);
  EXPECT_EQ(line.chain.size(), 3u);
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

TEST(PlaceRaster, TellsPlacesAndHeadingsApart) {
  PlaceRaster raster;
  const Pose2 here(-0.5, 3.5, 0.1);
  raster.add(here, 4);
  raster.add(Pose2(-0.9, 3.1, 0.7), 5);
  EXPECT_EQ(raster.count(here), 2u);
  EXPECT_EQ(raster.first(here), 4);
  for (const auto& other : {Pose2(0.5, 3.5, 0.1), Pose2(-0.5, 2.5, 0.1), Pose2(-0.5, 3.5, -0.1),
                            Pose2(-0.5, 3.5, 1.0)}) {
    EXPECT_EQ(raster.count(other), 0u);
    EXPECT_FALSE(raster.first(other));
  }
}

}  // namespace
}  // namespace slam::graph_slam
