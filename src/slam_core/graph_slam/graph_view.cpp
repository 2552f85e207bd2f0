// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_view.hpp"

#include <set>

#include "slam_core/graph/calibrated_factors.hpp"
#include "slam_core/graph/factors.hpp"

namespace slam::graph_slam {
namespace {

using graph::Factor;

template <class Kind>
bool is(const Factor& factor) {
  return dynamic_cast<const Kind*>(&factor) != nullptr;
}

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
    const bool is_between = is<graph::Between>(factor) || is<graph::CalibratedBetween>(factor);
    const bool is_sighting =
        is<graph::RangeBearing>(factor) || is<graph::CalibratedSighting>(factor);
    const bool is_prior = is<graph::PosePrior>(factor);
    if (is_between || is_sighting || is_prior) nodes_.insert(factor.keys().front());
    if (is_between) nodes_.insert(factor.keys()[1]);
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
    const auto from = graph_.pose(factor.keys()[0]), to = graph_.pose(factor.keys()[1]);
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
