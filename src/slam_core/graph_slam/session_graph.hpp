// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/optimizer.hpp"
#include "slam_core/graph/robust_loops.hpp"
#include "slam_core/graph_slam/session.hpp"

namespace slam::graph_slam {

/// The numbers that a graph's variables and factors get in a session. Variables without factors,
/// and keys and factors that were removed, get none.
class SessionNumbers {
 public:
  /// @param landmarks their keys, in the order of the session @param loops which are no factors of
  /// the session
  SessionNumbers(const graph::Optimizer& graph, const std::vector<graph::Key>& landmarks,
                 const std::vector<graph::RobustLoops::State>& loops);

  /// @return the number of a node or landmark @throw std::logic_error where it has no factor
  Session::Index variable(graph::Key key) const;
  std::optional<Session::Index> variable(const std::optional<graph::Key>& key) const;
  Session::Index factor(graph::FactorId id) const { return factors_[static_cast<std::size_t>(id)]; }
  const std::vector<graph::Key>& nodes() const { return nodes_; }

 private:
  friend void write(const graph::Optimizer& graph, const SessionNumbers& numbers, Session& session);
  std::vector<graph::Key> nodes_;
  std::vector<std::optional<Session::Index>> variables_;  ///< by key
  std::vector<Session::Index> factors_;                   ///< by id
  std::vector<std::shared_ptr<const graph::Factor>> in_order_;
};

/// Writes the nodes and factors of a graph.
void write(const graph::Optimizer& graph, const SessionNumbers& numbers, Session& session);

Session::Between recordOf(const graph::Between& factor, const SessionNumbers& numbers);

/// The variables and factors of a session's graph have these numbers where it is built first.
inline graph::Key keyOfNode(Session::Index node) { return static_cast<graph::Key>(node); }
inline graph::Key keyOfLandmark(const Session& session, Session::Index landmark) {
  return static_cast<graph::Key>(session.nodes.size() + landmark);
}
inline graph::FactorId idOfFactor(Session::Index factor) {
  return static_cast<graph::FactorId>(factor);
}

/// Adds all variables and factors but the loops to an empty graph.
void build(const Session& session, graph::Optimizer& graph);
/// The loops, to be restored or judged in the session's graph.
std::vector<graph::RobustLoops::State> loopsOf(const Session& session);
/// The graph of a session with the loops that are believed, to be optimised outside a back-end.
graph::Optimizer optimizerOf(const Session& session);
/// Takes over where the graph has the session's nodes and landmarks.
void follow(const graph::Optimizer& graph, Session& session);

}  // namespace slam::graph_slam
