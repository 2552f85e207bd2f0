// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_report.hpp"

#include <algorithm>
#include <numeric>

#include "trajectory_error.hpp"

namespace slam::eval {
namespace {

constexpr double kNoChi2 = 1e-6;  // of a graph without loops: a ratio to it means nothing

nlohmann::json stepTimes(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const double sum = std::accumulate(ms.begin(), ms.end(), 0.0);
  return {{"cpu_s", 1e-3 * sum},
          {"mean_ms", sum / static_cast<double>(ms.size())},
          {"p99_ms", ms[ms.size() * 99 / 100]},
          {"worst_ms", ms.back()}};
}

nlohmann::json batchSummary(const BatchResult& batch) {
  return {{"chi2", batch.chi2},
          {"cpu_s", batch.cpu_s},
          {"iterations", batch.iterations},
          {"has_converged", batch.has_converged}};
}

void addBatch(const PoseGraph& graph, const SolvedGraph& solved, nlohmann::json& report) {
  const double least = std::min(solved.batch.chi2, solved.polished.chi2);
  report["ceres"] = batchSummary(solved.batch);
  report["ceres_from_result"] = batchSummary(solved.polished);
  if (least > kNoChi2) report["chi2_ratio"] = report["chi2"].get<double>() / least;
  if (!graph.truth.empty())
    report["ceres_error_m"] = positionError(solved.batch.poses, graph.truth);
}

template <class Condition>
auto countEdges(const PoseGraph& graph, Condition condition) {
  return std::count_if(graph.edges.begin(), graph.edges.end(), condition);
}

}  // namespace

nlohmann::json summary(const PoseGraph& graph, const SolvedGraph& solved) {
  auto report = stepTimes(solved.steps.step_ms);
  report["name"] = graph.name;
  report["poses"] = graph.size();
  report["edges"] = graph.edges.size();
  report["loops"] = countEdges(graph, [](const PoseEdge& edge) { return edge.isLoop(); });
  report["false_loops"] = countEdges(graph, [](const PoseEdge& edge) { return edge.is_false; });
  report["left_out"] = graph.left_out;
  report["marginals_s"] = 1e-3 * solved.steps.marginals_ms;
  report["memory_mb"] = solved.memory_mb;
  report["tree_mb"] = solved.steps.tree_mb;
  report["chi2"] = eval::chi2(graph, solved.steps.poses);
  if (!graph.truth.empty()) {
    report["error_m"] = positionError(solved.steps.poses, graph.truth);
    report["dead_reckoning_error_m"] = positionError(deadReckoning(graph), graph.truth);
  }
  if (solved.is_robust) {
    report["true_loops_rejected"] = solved.steps.loops.true_rejected;
    report["false_loops_believed"] = solved.steps.loops.false_believed;
  } else {
    addBatch(graph, solved, report);
  }
  return report;
}

nlohmann::json details(const PoseGraph& graph, const SolvedGraph& solved) {
  auto poses = nlohmann::json::array(), loops = poses, truth = poses;
  for (const auto& pose : solved.steps.poses) poses.push_back({pose.x(), pose.y(), pose.theta()});
  for (const auto& edge : graph.edges)
    if (edge.isLoop()) loops.push_back({edge.a, edge.b, edge.is_false});
  if (!graph.truth.empty()) {
    const Pose2 T_map_truth = alignment(graph.truth, solved.steps.poses);
    for (const auto& pose : graph.truth) {
      const auto position = T_map_truth.transform(pose.position());
      truth.push_back({position.x(), position.y()});
    }
  }
  return {{"trajectory", poses},
          {"loop_edges", loops},
          {"steps_ms", solved.steps.step_ms},
          {"truth", truth}};
}

}  // namespace slam::eval
