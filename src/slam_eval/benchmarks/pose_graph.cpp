// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pose_graph.hpp"

namespace slam::eval {

void keepFirst(PoseGraph& graph, std::size_t poses) {
  if (poses >= graph.size()) return;
  graph.ids.resize(poses);
  if (!graph.truth.empty()) graph.truth.resize(poses);
  const auto is_beyond = [poses](const PoseEdge& edge) {
    return static_cast<std::size_t>(edge.newer()) >= poses;
  };
  auto& edges = graph.edges;
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_beyond), edges.end());
}

std::vector<std::vector<PoseEdge>> edgesByPose(const PoseGraph& graph) {
  std::vector<std::vector<PoseEdge>> edges(graph.size());
  for (const auto& edge : graph.edges)
    edges[static_cast<std::size_t>(edge.newer())].push_back(edge);
  return edges;
}

const PoseEdge& placingEdge(const std::vector<PoseEdge>& edges) {
  const auto places_worse = [](const PoseEdge& one, const PoseEdge& other) {
    if (one.is_false != other.is_false) return one.is_false;
    return one.older() < other.older();
  };
  return *std::max_element(edges.begin(), edges.end(), places_worse);
}

std::vector<Pose2> deadReckoning(const PoseGraph& graph) {
  const auto edges = edgesByPose(graph);
  std::vector<Pose2> poses = {graph.start};
  for (std::size_t i = 1; i < graph.size(); ++i) {
    const auto& edge = placingEdge(edges[i]);
    poses.push_back(edge.placed(poses[static_cast<std::size_t>(edge.older())]));
  }
  return poses;
}

double chi2(const PoseGraph& graph, const std::vector<Pose2>& poses) {
  double sum = 0.0;
  for (const auto& edge : graph.edges) {
    const auto e =
        edge.error(poses[static_cast<std::size_t>(edge.a)], poses[static_cast<std::size_t>(edge.b)])
            .vector();
    sum += e.dot(edge.information * e);
  }
  return sum;
}

}  // namespace slam::eval
