// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// The bounded queue of one source, in the order of stamps. What is not newer than the last one is
/// dropped as "late"; what is older by more than kStampJump may be the beginning of a new run and
/// is kept aside until the other sources tell. The last one, when it jumped ahead and the next one
/// did not, had a wrong stamp: it is dropped as "stamp_jump".
template <class T>
class StampedQueue {
 public:
  struct Item {
    Stamp stamp;
    T value;
  };

  explicit StampedQueue(std::size_t capacity = 1000) : capacity_(capacity) {}

  void push(Stamp stamp, std::uint64_t sequence, T value, Counters& counters) {
    if (lastWasWrong(stamp)) {
      items_.pop_back();
      last_ = std::exchange(before_jump_, std::nullopt);
      counters.add("stamp_jump");
    }
    const bool may_be_new_run = last_ && stamp <= *last_ - kStampJump;
    const bool follows_new_run = last_ && stamp <= *last_ && !aside_.empty();
    if (may_be_new_run || follows_new_run) {
      pushAside(stamp, sequence, std::move(value), counters);
      return;
    }
    if (last_ && stamp <= *last_) {
      counters.add("late");
      if (next_sequence_ == sequence) ++*next_sequence_;  // late, not lost as well
      return;
    }
    counters.add("late", aside_.size());
    aside_.clear();
    countGap(sequence, counters);
    before_jump_ = last_ && stamp > *last_ + kStampJump ? last_ : std::nullopt;
    last_ = stamp;
    items_.push_back({stamp, std::move(value)});
    if (items_.size() <= capacity_) return;
    items_.pop_front();
    counters.add("overflow");
  }

  /// Puts back what pop() took, or its rest.
  void pushFront(Stamp stamp, T value) { items_.push_front({stamp, std::move(value)}); }

  Item pop() {
    Item item = std::move(items_.front());
    items_.pop_front();
    return item;
  }

  bool empty() const { return items_.empty(); }
  std::size_t size() const { return items_.size(); }
  const Item& front() const { return items_.front(); }
  const Item& operator[](std::size_t index) const { return items_[index]; }
  /// The newest stamp accepted, whether or not it is still held.
  std::optional<Stamp> last() const { return last_; }
  bool wentBack() const { return !aside_.empty(); }

  /// Forgets the old run and goes on with what was kept aside.
  void restart() {
    items_ = std::exchange(aside_, {});
    last_.reset();
    before_jump_.reset();
    if (!items_.empty()) last_ = items_.back().stamp;
    next_sequence_ = aside_sequence_;
  }

 private:
  bool lastWasWrong(Stamp stamp) const {
    return before_jump_ && !items_.empty() && *before_jump_ < stamp && stamp < *last_ &&
           aside_.empty();
  }

  void pushAside(Stamp stamp, std::uint64_t sequence, T value, Counters& counters) {
    if (aside_.size() >= capacity_ || (!aside_.empty() && stamp <= aside_.back().stamp)) {
      counters.add("late");
      return;
    }
    aside_.push_back({stamp, std::move(value)});
    aside_sequence_ = sequence + 1;
  }

  void countGap(std::uint64_t sequence, Counters& counters) {
    if (next_sequence_ && sequence > *next_sequence_)
      counters.add("lost", sequence - *next_sequence_);
    next_sequence_ = sequence + 1;
  }

  std::size_t capacity_;
  std::deque<Item> items_, aside_;
  std::optional<Stamp> last_;
  std::optional<Stamp> before_jump_;  ///< the stamp before last_, when it jumped ahead from there
  std::optional<std::uint64_t> next_sequence_, aside_sequence_;
};

}  // namespace slam
