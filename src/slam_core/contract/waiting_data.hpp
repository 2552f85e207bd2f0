// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "slam_core/common/time.hpp"

namespace slam {

/// A sensor's data that wait until another sensor has come as far, so that the order of arrival
/// does not matter. They wait at most for one second of their own stamps.
/// @tparam Datum of the sensor, with its stamp
template <class Datum>
class WaitingData {
 public:
  struct Due {
    Datum datum;
    bool is_covered;  ///< or else it has waited in vain
  };

  void add(const Datum& datum) { waiting_.push_back(datum); }
  void clear() { waiting_.clear(); }
  /// The oldest of the data, if it need not wait any more.
  /// @param covered the stamp up to which the other sensor has come
  std::optional<Due> next(const std::optional<Stamp>& covered) {
    if (waiting_.empty()) return std::nullopt;
    const bool is_covered = covered && *covered >= waiting_.front().stamp;
    if (!is_covered && isPatient()) return std::nullopt;
    std::optional<Due> due(Due{std::move(waiting_.front()), is_covered});
    waiting_.pop_front();
    return due;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(waiting_);
  }

 private:
  static constexpr Duration kPatience = std::chrono::seconds(1);
  static constexpr std::size_t kCapacity = 100;

  bool isPatient() const {
    const auto waited = waiting_.back().stamp - waiting_.front().stamp;
    return waited >= Duration::zero() && waited < kPatience && waiting_.size() <= kCapacity;
  }

  std::deque<Datum> waiting_;
};

}  // namespace slam
