// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <map>

#include "slam_ros/graph_markers.hpp"

namespace slam_ros {
namespace {

using slam::GraphEdge;
using visualization_msgs::Marker;

class GraphMarkers : public testing::Test {
 protected:
  std::map<std::string, Marker> markers() const {
    std_msgs::Header header;
    header.frame_id = "map";
    std::map<std::string, Marker> by_name;
    for (const auto& marker : toMarkers(graph, header).markers) by_name[marker.ns] = marker;
    return by_name;
  }
  slam::GraphView graph;
};

TEST_F(GraphMarkers, AreOneForEachKindAndDeleteThoseThatTheGraphHasNot) {
  graph.nodes = {slam::Pose2(1, 2, 0), slam::Pose2(3, 4, 0)};
  graph.edges = {{GraphEdge::Kind::kMotion, {1, 2}, {3, 4}, 1.0}};
  const auto found = markers();
  ASSERT_EQ(found.size(), 6u);
  for (const auto& [name, marker] : found) {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_EQ(marker.action == Marker::ADD, name == "nodes" || name == "motion") << name;
    EXPECT_EQ(marker.points.empty(), marker.action == Marker::DELETE) << name;
  }
  const auto& points = found.at("motion").points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].x, 3.0);
  EXPECT_EQ(points[1].y, 4.0);
}

TEST_F(GraphMarkers, TurnOrangeWhereALoopCountsLess) {
  graph.edges = {{GraphEdge::Kind::kLoop, {0, 0}, {1, 0}, 1.0},
                 {GraphEdge::Kind::kLoop, {0, 0}, {1, 0}, 0.2}};
  const auto colours = markers().at("loops").colors;
  ASSERT_EQ(colours.size(), 4u) << "one for each end";
  EXPECT_GT(colours[0].g, colours[0].r) << "green";
  EXPECT_GT(colours[2].r, colours[2].g) << "orange";
}

TEST_F(GraphMarkers, AreBoundedHoweverLargeTheGraphIs) {
  graph.nodes.resize(3 * kMostDrawn + 1);
  graph.edges.assign(2 * kMostDrawn + 1, {GraphEdge::Kind::kLoop, {0, 0}, {1, 0}, 1.0});
  const auto found = markers();
  EXPECT_LE(found.at("nodes").points.size(), kMostDrawn);
  EXPECT_GT(found.at("nodes").points.size(), kMostDrawn / 2);
  EXPECT_LE(found.at("loops").points.size(), 2 * kMostDrawn);
  EXPECT_GT(found.at("loops").points.size(), kMostDrawn);
  EXPECT_EQ(found.at("loops").points.size(), found.at("loops").colors.size());
}

}  // namespace
}  // namespace slam_ros
