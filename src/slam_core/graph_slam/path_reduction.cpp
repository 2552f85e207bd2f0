// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/path_reduction.hpp"

#include <algorithm>

namespace slam::graph_slam {
namespace {

/// So many of the last nodes stay.
constexpr std::size_t kWindow = 100;
/// So many nodes before and after one at a new place stay with it and tie it to the map.
constexpr std::size_t kLead = 5;
/// A landmark that was seen from so many nodes that stay is known.
constexpr std::size_t kSightings = 30;

}  // namespace

void PathReduction::reduce() {
  for (const auto node : chainOf(path_).takeNew()) {
    if (newest_ >= 0 && isToBeJudged(newest_)) window_.push_back(newest_);
    newest_ = node;
    open_.insert(node);
  }
  for (; window_.size() > kWindow; window_.pop_front()) judge(window_.front());
}

/// Nodes that only scans that are drawn need go with those.
bool PathReduction::isToBeJudged(graph::Key node) const {
  if (!sightingsOf(landmarks_).seenFrom(node).empty()) return true;
  return !is_held_(node) && !chainOf(path_)[node].has_prior;
}

void PathReduction::judge(graph::Key node) {
  if (isNew(node)) {
    for (const auto before : leaving_) settle(before);
    leaving_.clear();
    settle(node);
    to_keep_ = kLead;
  } else if (to_keep_ > 0) {
    settle(node);
    --to_keep_;
  } else {
    leaving_.push_back(node);
  }
  const std::size_t lead = limits_.map_is_fixed ? 0 : kLead;
  for (; leaving_.size() > lead; leaving_.pop_front()) remove(leaving_.front());
}

/// It stays, so that its place and what it sees count.
void PathReduction::settle(graph::Key node) {
  open_.erase(node);
  places_.add(path_.graph().pose(node), node);
}

void PathReduction::keepAll() {
  for (const auto node : chainOf(path_).takeNew()) places_.add(path_.graph().pose(node), node);
}

/// What only recent nodes have seen is not known yet: most of them will go.
bool PathReduction::isKnown(std::size_t landmark) const {
  if (limits_.map_is_fixed) return true;
  const auto nodes = sightingsOf(landmarks_).nodesThatSaw(landmark);
  const auto settled = std::count_if(nodes.begin(), nodes.end(),
                                     [this](graph::Key node) { return open_.count(node) == 0; });
  return static_cast<std::size_t>(settled) > kSightings;
}

bool PathReduction::isNew(graph::Key node) const {
  if (limits_.map_is_fixed) return false;
  if (places_.count(path_.graph().pose(node)) < limits_.nodes_per_place) return true;
  const auto& seen = sightingsOf(landmarks_).seenFrom(node);
  return !std::all_of(seen.begin(), seen.end(), [this](auto each) { return isKnown(each); });
}

void PathReduction::remove(graph::Key node) {
  open_.erase(node);
  const auto& chain = chainOf(path_)[node];
  if (chain.has_prior || chain.before < 0) return;
  if (is_held_(node)) {
    dropSightings(node);
    return;
  }
  hangRecord(node);
  dropSightings(node);
  forget_(node);
  chainOf(path_).remove(node);
  ++removed_;
}

void PathReduction::dropSightings(graph::Key node) {
  for (const auto factor : sightingsOf(landmarks_).removeNode(node)) path_.graph().remove(factor);
}

void PathReduction::release(graph::Key node) {
  const auto is_in = [node](const std::deque<graph::Key>& nodes) {
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  const bool has_sightings = !sightingsOf(landmarks_).seenFrom(node).empty();
  if (!has_sightings && !is_in(window_) && !is_in(leaving_) && node != newest_) remove(node);
}

/// The poses that hang on a node go to one at the same place, or to a neighbour. In a fixed map
/// they are where they are.
void PathReduction::hangRecord(graph::Key node) {
  const auto& graph = path_.graph();
  graph::Key to = -1;
  if (!limits_.map_is_fixed) {
    const auto& chain = chainOf(path_)[node];
    to = places_.first(graph.pose(node)).value_or(chain.before >= 0 ? chain.before : chain.after);
  }
  record_.hang(node, to, graph);
}

}  // namespace slam::graph_slam
