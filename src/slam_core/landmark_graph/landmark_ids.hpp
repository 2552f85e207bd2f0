// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::landmark_graph {

/// The ids of landmarks, which are numbered in the order in which they come.
class LandmarkIds {
 public:
  std::size_t size() const { return ids_.size(); }
  LandmarkId operator[](std::size_t number) const { return ids_[number]; }
  std::optional<std::size_t> find(LandmarkId id) const {
    const auto found = number_.find(id);
    if (found == number_.end()) return std::nullopt;
    return found->second;
  }
  /// @param id replaced by one that nobody has, where it is unknown or another's
  void add(LandmarkId id) {
    if (id == kUnknownId || find(id)) id = largest_ + 1;
    number_[id] = ids_.size();
    ids_.push_back(id);
    largest_ = std::max(largest_, id);
  }
  /// A landmark is not found any more, nor in order(). Its number is not given again; its id only
  /// to who brings it.
  void retire(LandmarkId id) { number_.erase(id); }
  bool isRetired(std::size_t number) const { return find(ids_[number]) != number; }
  /// @return the number of landmarks that are not retired
  std::size_t inMap() const { return number_.size(); }
  /// The numbers sorted by id.
  std::vector<std::size_t> order() const {
    std::vector<std::size_t> order(ids_.size());
    std::iota(order.begin(), order.end(), 0);
    const auto is_retired = [this](std::size_t number) { return isRetired(number); };
    order.erase(std::remove_if(order.begin(), order.end(), is_retired), order.end());
    std::sort(order.begin(), order.end(),
              [this](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
    return order;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(ids_, largest_, number_);
  }

 private:
  std::vector<LandmarkId> ids_;
  LandmarkId largest_ = kUnknownId;
  std::unordered_map<LandmarkId, std::size_t> number_;  // looked up only, never iterated
};

}  // namespace slam::landmark_graph
