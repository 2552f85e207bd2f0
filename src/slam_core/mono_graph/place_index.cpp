// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/place_index.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace slam::mono_graph {
namespace {

constexpr int kNextTo = 5;  // keyframes that are so near in time are of one place

}  // namespace

void PlaceIndex::add(BagOfWords bag) {
  bags_.push_back(std::move(bag));
  list(static_cast<int>(bags_.size()) - 1);
}

void PlaceIndex::list() {
  entries_.clear();
  for (std::size_t i = 0; i < bags_.size(); ++i) list(static_cast<int>(i));
}

void PlaceIndex::list(int keyframe) {
  const auto& bag = (*this)[keyframe];
  if (!bag.words.empty() && bag.words.back() >= entries_.size())
    entries_.resize(bag.words.back() + std::size_t{1});
  for (std::size_t i = 0; i < bag.words.size(); ++i)
    entries_[bag.words[i]].push_back({keyframe, bag.weights[i]});
}

std::vector<PlaceCandidate> PlaceIndex::find(const BagOfWords& bag, const std::set<int>& left_out,
                                             std::size_t most) const {
  std::vector<PlaceCandidate> all(bags_.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].keyframe = static_cast<int>(i);
  for (std::size_t i = 0; i < bag.words.size(); ++i) {
    if (bag.words[i] >= entries_.size()) break;
    for (const auto& [keyframe, weight] : entries_[bag.words[i]])
      all[static_cast<std::size_t>(keyframe)].similarity += std::min(weight, bag.weights[i]);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.similarity > b.similarity; });
  std::vector<PlaceCandidate> found;
  for (const auto& candidate : all) {
    if (found.size() >= most || !(candidate.similarity > 0.0)) break;
    const bool is_known = std::any_of(found.begin(), found.end(), [&](const auto& other) {
      return std::abs(other.keyframe - candidate.keyframe) <= kNextTo;
    });
    if (!is_known && left_out.count(candidate.keyframe) == 0) found.push_back(candidate);
  }
  return found;
}

}  // namespace slam::mono_graph
