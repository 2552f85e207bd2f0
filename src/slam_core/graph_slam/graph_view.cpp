// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_view.hpp"

#include <set>

#include "slam_core/graph/factors.hpp"

namespace slam::graph_slam {
namespace {

using graph::Factor;

/// Collects what the factors join.
class GraphPicture {
 public:
  explicit GraphPicture(const graph::Optimizer& graph) : graph_(graph) {}

  void addLoop(const Factor& loop, double weight) {
    using Kind = GraphEdge::Kind;
    loops_.insert(&loop);
    addEdge(weight > 0.0 ? Kind::kLoop : Kind::kWaitingLoop, loop, weight);
  }
  /// Loops are known before.
  void addFactor(const Factor& factor, double weight) {
    const bool is_between = dynamic_cast<const graph::Between*>(&factor) != nullptr;
    const bool is_sighting = dynamic_cast<const graph::RangeBearing*>(&factor) != nullptr;
    const bool is_prior = dynamic_cast<const graph::PosePrior*>(&factor) != nullptr;
    if (is_between || is_sighting || is_prior) nodes_.insert(factor.keys().front());
    if (is_between) nodes_.insert(factor.keys().back());
    if (is_between && loops_.count(&factor) == 0) addEdge(GraphEdge::Kind::kMotion, factor, weight);
    if (is_sighting) addEdge(GraphEdge::Kind::kSighting, factor, weight);
  }
  void addSubmap(const Submap& submap) {
    if (submap.origin() >= 0) view_.submaps.push_back(graph_.pose(submap.origin()));
  }
  GraphView view() && {
    for (const auto node : nodes_) view_.nodes.push_back(graph_.pose(node));
    return std::move(view_);
  }

 private:
  void addEdge(GraphEdge::Kind kind, const Factor& factor, double weight) {
    const auto from = graph_.pose(factor.keys().front()), to = graph_.pose(factor.keys().back());
    view_.edges.push_back({kind, from.position(), to.position(), weight});
  }

  const graph::Optimizer& graph_;
  std::set<const Factor*> loops_;  // only looked up, since the order of addresses means nothing
  std::set<graph::Key> nodes_;
  GraphView view_;
};

}  // namespace

GraphView viewOf(const graph::Optimizer& graph, const ScanGraph* scans) {
  GraphPicture picture(graph);
  if (scans != nullptr) {
    for (const auto& loop : scans->loops_.states())
      picture.addLoop(*loop.factor, loop.is_believed ? loop.weight : 0.0);
    for (const auto& finished : scans->submaps_.finished()) picture.addSubmap(finished.submap);
    picture.addSubmap(scans->submaps_.current());
  }
  visitFactors(graph, [&](const auto& each, double weight) { picture.addFactor(each, weight); });
  return std::move(picture).view();
}

}  // namespace slam::graph_slam
