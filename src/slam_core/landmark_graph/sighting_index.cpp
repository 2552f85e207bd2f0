// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/sighting_index.hpp"

#include <algorithm>

namespace slam::landmark_graph {

void SightingIndex::add(std::size_t landmark, graph::Key node, graph::FactorId factor) {
  of_landmark_[landmark].push_back({node, factor});
  of_node_[node].push_back(landmark);
}

graph::FactorId SightingIndex::factor(std::size_t landmark, graph::Key node) const {
  const auto& sightings = of_landmark_[landmark];
  return std::find_if(sightings.begin(), sightings.end(),
                      [&](const Sighting& each) { return each.node == node; })
      ->factor;
}

graph::FactorId SightingIndex::remove(std::size_t landmark, graph::Key node) {
  auto& sightings = of_landmark_[landmark];
  const auto found = std::find_if(sightings.begin(), sightings.end(),
                                  [&](const Sighting& each) { return each.node == node; });
  const auto factor = found->factor;
  sightings.erase(found);
  auto& landmarks = of_node_[node];
  landmarks.erase(std::find(landmarks.begin(), landmarks.end(), landmark));
  return factor;
}

std::vector<graph::FactorId> SightingIndex::removeLandmark(std::size_t landmark) {
  std::vector<graph::FactorId> factors;
  for (const auto& [node, factor] : of_landmark_[landmark]) {
    factors.push_back(factor);
    if (node < 0) continue;
    auto& landmarks = of_node_[node];
    landmarks.erase(std::find(landmarks.begin(), landmarks.end(), landmark));
  }
  of_landmark_[landmark].clear();
  return factors;
}

std::vector<graph::FactorId> SightingIndex::removeNode(graph::Key node) {
  std::vector<graph::FactorId> factors;
  const auto landmarks = seenFrom(node);
  for (const auto landmark : landmarks) factors.push_back(remove(landmark, node));
  of_node_.erase(node);
  return factors;
}

std::vector<graph::Key> SightingIndex::nodesThatSaw(std::size_t landmark) const {
  std::vector<graph::Key> nodes;
  for (const auto& sighting : of_landmark_[landmark]) nodes.push_back(sighting.node);
  return nodes;
}

const std::vector<std::size_t>& SightingIndex::seenFrom(graph::Key node) const {
  static const std::vector<std::size_t> kNone;
  const auto found = of_node_.find(node);
  return found == of_node_.end() ? kNone : found->second;
}

}  // namespace slam::landmark_graph
