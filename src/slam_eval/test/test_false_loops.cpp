// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "false_loops.hpp"
#include "graph_world.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

constexpr int kCount = 50;

PoseGraph city() {
  GraphWorldConfig config;
  config.poses = 500;
  return makeGraphWorld(config, 1);
}

std::vector<PoseEdge> falseLoops(FalseLoopKind kind, std::uint64_t seed = 1) {
  auto graph = city();
  const std::size_t before = graph.edges.size();
  addFalseLoops(graph, kind, kCount, seed);
  return {graph.edges.begin() + static_cast<std::ptrdiff_t>(before), graph.edges.end()};
}

/// How many loops lead on from the one before, with the same measurement.
int followers(const std::vector<PoseEdge>& loops) {
  int count = 0;
  for (std::size_t i = 1; i < loops.size(); ++i)
    count += loops[i].a == loops[i - 1].a + 1 && loops[i].b == loops[i - 1].b + 1 &&
             loops[i].z.vector() == loops[i - 1].z.vector();
  return count;
}

int longest(const std::vector<PoseEdge>& loops) {
  int most = 0;
  for (const auto& loop : loops) most = std::max(most, loop.newer() - loop.older());
  return most;
}

TEST(FalseLoops, AreSoManyMarkedAndAsSureAsTrueOnes) {
  const auto graph = city();
  for (const auto kind : {FalseLoopKind::kRandom, FalseLoopKind::kLocal,
                          FalseLoopKind::kRandomGroups, FalseLoopKind::kLocalGroups}) {
    const auto loops = falseLoops(kind);
    ASSERT_EQ(loops.size(), static_cast<std::size_t>(kCount));
    for (const auto& loop : loops) {
      EXPECT_TRUE(loop.is_false && loop.isLoop());
      EXPECT_EQ(loop.information, graph.edges[0].information);
    }
  }
}

TEST(FalseLoops, ContradictTheTruth) {
  const auto graph = city();
  for (const auto kind : {FalseLoopKind::kRandom, FalseLoopKind::kLocalGroups})
    for (const auto& loop : falseLoops(kind)) {
      const auto e = loop.error(graph.truth[static_cast<std::size_t>(loop.a)],
                                graph.truth[static_cast<std::size_t>(loop.b)])
                         .vector();
      EXPECT_GT(e.dot(loop.information * e), 16.0);
      EXPECT_LT(loop.z.position().norm(), 2.0);  // it says: the same place
    }
}

TEST(FalseLoops, LieAsTheirKindSays) {
  EXPECT_GT(longest(falseLoops(FalseLoopKind::kRandom)), 100);
  EXPECT_LE(longest(falseLoops(FalseLoopKind::kLocal)), 20);
  EXPECT_GT(longest(falseLoops(FalseLoopKind::kRandomGroups)), 50);
  EXPECT_LE(longest(falseLoops(FalseLoopKind::kLocalGroups)), 20);
  EXPECT_EQ(followers(falseLoops(FalseLoopKind::kRandom)), 0);
  EXPECT_EQ(followers(falseLoops(FalseLoopKind::kLocal)), 0);
  EXPECT_EQ(followers(falseLoops(FalseLoopKind::kRandomGroups)), kCount - 3);  // 20, 20, 10
  EXPECT_EQ(followers(falseLoops(FalseLoopKind::kLocalGroups)), kCount - 3);
}

TEST(FalseLoops, AreTheSameForOneSeedAndOthersForOthers) {
  const auto places = [](const std::vector<PoseEdge>& loops) {
    std::vector<std::pair<int, int>> pairs;
    for (const auto& loop : loops) pairs.emplace_back(loop.a, loop.b);
    return pairs;
  };
  const auto first = places(falseLoops(FalseLoopKind::kRandom));
  EXPECT_EQ(first, places(falseLoops(FalseLoopKind::kRandom, 1)));
  EXPECT_NE(first, places(falseLoops(FalseLoopKind::kRandom, 2)));
}

TEST(FalseLoops, PlaceNoPoseBeforeItIsSolved) {
  auto graph = city();
  const auto before = deadReckoning(graph);
  addFalseLoops(graph, FalseLoopKind::kLocal, 400, 1);
  const auto after = deadReckoning(graph);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].vector(), after[i].vector());
}

TEST(FalseLoops, GoByOdometryWhereTheTruthIsNotKnown) {
  auto graph = city();
  graph.truth.clear();
  const auto poses = deadReckoning(graph);
  addFalseLoops(graph, FalseLoopKind::kRandom, kCount, 1);
  for (const auto& loop : graph.edges) {
    if (!loop.is_false) continue;
    const auto e =
        loop.error(poses[static_cast<std::size_t>(loop.a)], poses[static_cast<std::size_t>(loop.b)])
            .vector();
    EXPECT_GT(e.dot(loop.information * e), 16.0);
  }
}

TEST(FalseLoops, NeedAGraphThatIsLargeEnough) {
  auto graph = city();
  keepFirst(graph, 2);
  addFalseLoops(graph, FalseLoopKind::kRandom, 0, 1);
  EXPECT_EQ(graph.edges.size(), 1u);
  const auto fault = messageOf<std::runtime_error>(
      [&graph] { addFalseLoops(graph, FalseLoopKind::kRandom, 1, 1); });
  EXPECT_NE(fault.find("a graph of 2 poses is too small for false loops of this kind; take"),
            std::string::npos)
      << fault;
}

}  // namespace
}  // namespace slam::eval
