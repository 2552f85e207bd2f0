// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_graph.hpp"

#include <stdexcept>
#include <string>
#include <unordered_set>

#include "slam_core/graph/calibrated_factors.hpp"

namespace slam::graph_slam {
namespace {

/// Builds the record of a factor, whichever kind it is.
class FactorRecorder {
 public:
  FactorRecorder(const SessionNumbers& numbers, const graph::Optimizer& graph)
      : numbers_(numbers), graph_(graph) {}

  Session::Factor operator()(const graph::Factor& factor) const {
    if (const auto* is = dynamic_cast<const graph::Between*>(&factor))
      return recordOf(*is, numbers_);
    if (const auto* is = dynamic_cast<const graph::RangeBearing*>(&factor))
      return Session::RangeBearing{variable(*is, 0), variable(*is, 1), is->sensor(), is->measured(),
                                   is->weight()};
    if (const auto* is = dynamic_cast<const graph::PosePrior*>(&factor))
      return Session::PosePrior{variable(*is, 0), is->known(), is->weight()};
    if (const auto* is = dynamic_cast<const graph::PointPrior*>(&factor))
      return Session::PointPrior{variable(*is, 0), is->known(), is->weight()};
    if (const auto* is = dynamic_cast<const graph::JointPrior*>(&factor)) return joint(*is);
    if (const auto* is = dynamic_cast<const graph::CalibratedBetween*>(&factor))
      return (*this)(is->with(estimates(factor)));
    if (const auto* is = dynamic_cast<const graph::CalibratedSighting*>(&factor))
      return (*this)(is->with(estimates(factor)));
    throw std::logic_error("a session has no record for a kind of factor that is in the graph");
  }

 private:
  Session::Index variable(const graph::Factor& factor, std::size_t i) const {
    return numbers_.variable(factor.keys()[i]);
  }
  std::vector<Pose2> estimates(const graph::Factor& factor) const {
    std::vector<Pose2> estimates;
    for (const auto key : factor.keys()) estimates.push_back(graph_.pose(key));
    return estimates;
  }
  Session::JointPrior joint(const graph::JointPrior& factor) const {
    Session::JointPrior record{
        variable(factor, 0), {}, factor.pose(), factor.points(), factor.weight()};
    for (std::size_t i = 1; i < factor.keys().size(); ++i)
      record.landmarks.push_back(variable(factor, i));
    return record;
  }

  const SessionNumbers& numbers_;
  const graph::Optimizer& graph_;
};

/// Builds a factor of its record.
class FactorBuilder {
 public:
  explicit FactorBuilder(const Session& session) : session_(session) {}
  using Built = std::shared_ptr<const graph::Factor>;

  Built operator()(const Session::PosePrior& it) const {
    return std::make_shared<graph::PosePrior>(keyOfNode(it.node), it.pose, it.weight);
  }
  Built operator()(const Session::PointPrior& it) const {
    return std::make_shared<graph::PointPrior>(landmark(it.landmark), it.point, it.weight);
  }
  Built operator()(const Session::JointPrior& it) const {
    std::vector<graph::Key> keys = {keyOfNode(it.node)};
    for (const auto number : it.landmarks) keys.push_back(landmark(number));
    return std::make_shared<graph::JointPrior>(keys, it.pose, it.points, it.weight);
  }
  Built operator()(const Session::Between& it) const {
    return std::make_shared<graph::Between>(keyOfNode(it.from), keyOfNode(it.to), it.motion,
                                            it.weight);
  }
  Built operator()(const Session::RangeBearing& it) const {
    return std::make_shared<graph::RangeBearing>(keyOfNode(it.node), landmark(it.landmark),
                                                 it.sensor, it.z, it.weight);
  }

 private:
  graph::Key landmark(Session::Index number) const { return keyOfLandmark(session_, number); }

  const Session& session_;
};

}  // namespace

SessionNumbers::SessionNumbers(const graph::Optimizer& graph,
                               const std::vector<graph::Key>& landmarks,
                               const std::vector<graph::RobustLoops::State>& loops) {
  const auto contents = graph::contentsOf(graph);
  variables_.resize(contents.is_pose.size());
  std::unordered_set<const graph::Factor*> left_out;  // looked up only, never iterated
  for (const auto& loop : loops) left_out.insert(loop.factor.get());
  std::vector<char> is_used(contents.is_pose.size(), 0);
  for (const auto& factor : contents.factors) {
    factors_.push_back(static_cast<Session::Index>(in_order_.size()));
    if (!factor) continue;
    for (const auto key : factor->keys()) is_used[static_cast<std::size_t>(key)] = 1;
    // a session is as it is with the parameters that were calibrated, and holds none
    const bool is_of_parameters =
        dynamic_cast<const graph::ParameterPrior*>(factor.get()) != nullptr;
    if (left_out.count(factor.get()) == 0 && !is_of_parameters) in_order_.push_back(factor);
  }
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    variables_[static_cast<std::size_t>(landmarks[i])] = static_cast<Session::Index>(i);
  for (std::size_t key = 0; key < is_used.size(); ++key) {
    if (is_used[key] == 0 || !contents.is_pose[key]) continue;
    variables_[key] = static_cast<Session::Index>(nodes_.size());
    nodes_.push_back(static_cast<graph::Key>(key));
  }
}

Session::Index SessionNumbers::variable(graph::Key key) const {
  const auto& number = variables_.at(static_cast<std::size_t>(key));
  if (!number) throw std::logic_error("a variable of the graph has no factor");
  return *number;
}

std::optional<Session::Index> SessionNumbers::variable(const std::optional<graph::Key>& key) const {
  if (!key) return std::nullopt;
  return variable(*key);
}

void write(const graph::Optimizer& graph, const SessionNumbers& numbers, Session& session) {
  for (const auto key : numbers.nodes()) session.nodes.push_back(graph.pose(key));
  const FactorRecorder record(numbers, graph);
  for (const auto& factor : numbers.in_order_) session.factors.push_back(record(*factor));
}

Session::Between recordOf(const graph::Between& factor, const SessionNumbers& numbers) {
  return {numbers.variable(factor.keys()[0]), numbers.variable(factor.keys()[1]), factor.measured(),
          factor.weight()};
}

void build(const Session& session, graph::Optimizer& graph) {
  for (const auto& node : session.nodes) graph.add(node);
  for (const auto& landmark : session.landmarks) graph.add(landmark.position);
  const FactorBuilder builder(session);
  for (const auto& factor : session.factors) graph.add(std::visit(builder, factor));
}

std::vector<graph::RobustLoops::State> loopsOf(const Session& session) {
  std::vector<graph::RobustLoops::State> states;
  const FactorBuilder builder(session);
  for (const auto& [between, is_believed, share, is_alone] : session.loops)
    states.push_back({builder(between), is_believed, share, is_alone});
  return states;
}

graph::Optimizer optimizerOf(const Session& session) {
  graph::Optimizer graph;
  build(session, graph);
  for (const auto& loop : loopsOf(session))
    if (loop.is_believed) graph.set(graph.add(loop.factor), loop.weight);
  return graph;
}

void follow(const graph::Optimizer& graph, Session& session) {
  for (std::size_t i = 0; i < session.nodes.size(); ++i)
    session.nodes[i] = graph.pose(keyOfNode(static_cast<Session::Index>(i)));
  for (std::size_t i = 0; i < session.landmarks.size(); ++i)
    session.landmarks[i].position =
        graph.pose(keyOfLandmark(session, static_cast<Session::Index>(i))).position();
}

}  // namespace slam::graph_slam
