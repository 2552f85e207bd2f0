// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/graph_markers.hpp"

#include <algorithm>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

using slam::GraphEdge;
using visualization_msgs::Marker;

struct Style {
  const char* name;
  double width;   ///< [m]
  double height;  ///< above the map [m]: what matters lies on top
  float r, g, b, a;
};

constexpr Style kNodes = {"nodes", 0.08, 0.05, 0.15F, 0.15F, 0.2F, 1.0F};
constexpr Style kSubmaps = {"submaps", 0.25, 0.06, 0.45F, 0.2F, 0.6F, 1.0F};
constexpr Style kMotion = {"motion", 0.05, 0.04, 0.4F, 0.4F, 0.4F, 1.0F};
constexpr Style kSightings = {"sightings", 0.01, 0.01, 0.25F, 0.5F, 0.95F, 0.5F};
constexpr Style kLoops = {"loops", 0.015, 0.02, 0.1F, 0.65F, 0.2F, 0.25F};
constexpr Style kDoubted = {"", 0.015, 0.02, 1.0F, 0.5F, 0.0F, 1.0F};
constexpr Style kWaiting = {"waiting_loops", 0.05, 0.045, 0.85F, 0.1F, 0.1F, 0.9F};

std_msgs::ColorRGBA colourOf(const Style& style) {
  std_msgs::ColorRGBA colour;
  colour.r = style.r;
  colour.g = style.g;
  colour.b = style.b;
  colour.a = style.a;
  return colour;
}

/// Green and pale where a loop counts in full, since there are thousands; orange where it hardly
/// counts.
std_msgs::ColorRGBA colourOfLoop(double weight) {
  const auto share = static_cast<float>(std::clamp(weight, 0.0, 1.0));
  const auto mixed = [share](float full, float none) {
    return share * full + (1.0F - share) * none;
  };
  std_msgs::ColorRGBA colour;
  colour.r = mixed(kLoops.r, kDoubted.r);
  colour.g = mixed(kLoops.g, kDoubted.g);
  colour.b = mixed(kLoops.b, kDoubted.b);
  colour.a = mixed(kLoops.a, kDoubted.a);
  return colour;
}

geometry_msgs::Point pointAt(const Eigen::Vector2d& position, double height) {
  geometry_msgs::Point point;
  point.x = position.x();
  point.y = position.y();
  point.z = height;
  return point;
}

Marker emptyMarker(const std_msgs::Header& header, const Style& style, int type) {
  Marker marker;
  marker.header = header;
  marker.ns = style.name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = style.width;
  marker.scale.z = type == Marker::SPHERE_LIST ? style.width : 0.0;
  marker.color = colourOf(style);
  return marker;
}

/// A marker without points would be a fault.
Marker finished(Marker marker) {
  marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
  return marker;
}

std::size_t strideFor(std::size_t count) { return (count + kMostDrawn - 1) / kMostDrawn; }

Marker pointsAt(const std::vector<slam::Pose2>& poses, const std_msgs::Header& header,
                const Style& style, int type) {
  auto marker = emptyMarker(header, style, type);
  for (std::size_t i = 0; i < poses.size(); i += strideFor(poses.size()))
    marker.points.push_back(pointAt(poses[i].position(), style.height));
  return finished(std::move(marker));
}

Marker linesOf(GraphEdge::Kind kind, const slam::GraphView& graph, const std_msgs::Header& header,
               const Style& style) {
  const auto is_of_kind = [kind](const auto& edge) { return edge.kind == kind; };
  const auto stride = strideFor(
      static_cast<std::size_t>(std::count_if(graph.edges.begin(), graph.edges.end(), is_of_kind)));
  auto marker = emptyMarker(header, style, Marker::LINE_LIST);
  std::size_t number = 0;
  for (const auto& edge : graph.edges) {
    if (!is_of_kind(edge) || number++ % stride != 0) continue;
    for (const auto& end : {edge.from, edge.to})
      marker.points.push_back(pointAt(end, style.height));
    if (kind == GraphEdge::Kind::kLoop)
      marker.colors.insert(marker.colors.end(), 2, colourOfLoop(edge.weight));
  }
  return finished(std::move(marker));
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const slam::GraphView& graph,
                                          const std_msgs::Header& header) {
  using Kind = GraphEdge::Kind;
  visualization_msgs::MarkerArray array;
  array.markers = {linesOf(Kind::kSighting, graph, header, kSightings),
                   linesOf(Kind::kMotion, graph, header, kMotion),
                   linesOf(Kind::kLoop, graph, header, kLoops),
                   linesOf(Kind::kWaitingLoop, graph, header, kWaiting),
                   pointsAt(graph.nodes, header, kNodes, Marker::POINTS),
                   pointsAt(graph.submaps, header, kSubmaps, Marker::SPHERE_LIST)};
  return array;
}

}  // namespace slam_ros
