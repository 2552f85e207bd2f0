// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/sequence_watch.hpp"
#include "slam_core/common/stamp_jump.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// The bounded queue of one source, in the order of stamps. What is not newer than the last one is
/// dropped as "late"; what is older by more than kStampJump may be the beginning of a new run and
/// is kept aside until the other sources tell.
///
/// Stamps that jump ahead may be wrong (StampJump): one of them is dropped as "stamp_jump" when the
/// next one did not jump, several of them once kInARow messages in a row have stamps from before
/// the jump, unless the receiver has already gone beyond those (goneTo()).
template <class T>
class StampedQueue {
 public:
  struct Item {
    Stamp stamp;
    T value;

    template <class Archive>
    void persist(Archive& archive) {
      archive(stamp, value);
    }
  };
  static constexpr std::size_t kInARow = StampJump::kInARow;

  explicit StampedQueue(std::size_t capacity = 1000) : capacity_(capacity) {}

  void push(Stamp stamp, std::uint64_t sequence, T value, Counters& counters) {
    if (!items_.empty() && aside_.empty() && stamps_.isRefutedBy(stamp)) {
      items_.pop_back();
      stamps_.forget(stamps_.before());
      counters.add("stamp_jump");
    }
    const auto last = stamps_.last();
    const bool may_be_new_run = last && stamp <= *last - kStampJump;
    const bool follows_new_run = last && stamp <= *last && !aside_.empty();
    if (may_be_new_run || follows_new_run) {
      pushAside(stamp, sequence, std::move(value), counters);
      return;
    }
    if (last && stamp <= *last) {
      counters.add("late");
      sequence_.skip(sequence);  // late, not lost as well
      return;
    }
    counters.add("late", aside_.size());
    aside_.clear();
    counters.add("lost", sequence_.lostBefore(sequence, last ? stamp - *last : Duration()));
    stamps_.note(stamp);
    items_.push_back({stamp, std::move(value)});
    if (items_.size() <= capacity_) return;
    items_.pop_front();
    counters.add("overflow");
  }

  /// A message that is no use and does not count as lost either.
  void skip(std::uint64_t sequence) { sequence_.skip(sequence); }

  /// Puts back what pop() took, or its rest.
  void pushFront(Stamp stamp, T value) { items_.push_front({stamp, std::move(value)}); }

  Item pop() {
    Item item = std::move(items_.front());
    items_.pop_front();
    return item;
  }

  /// The receiver is done with all up to here and cannot take older messages any more.
  void goneTo(Stamp stamp) { gone_to_ = stamp; }

  const std::deque<Item>& items() const { return items_; }
  /// The stamps accepted, whether or not their messages are still held.
  const StampJump& stamps() const { return stamps_; }
  /// Messages that went back and wait until it is known whether they begin a new run.
  std::size_t setAside() const { return aside_.size(); }
  /// Whether some went back and are not the end of a jump ahead that nothing has come of.
  bool beganAnew() const { return !aside_.empty() && !(stamps_.before() && returnsFromJump()); }

  /// Forgets the old run and goes on with what was kept aside.
  /// @return how many messages of the old run were held
  std::size_t restart() {
    const auto held = items_.size();
    items_ = std::exchange(aside_, {});
    stamps_.forget(items_.empty() ? std::nullopt : std::optional(items_.back().stamp));
    gone_to_.reset();
    sequence_ = aside_sequence_;
    return held;
  }

  template <class Archive>
  void persist(Archive& archive, const T& alike = T()) {
    const auto make = [&alike] { return Item{Stamp(), alike}; };
    archive.list(items_, make);
    archive.list(aside_, make);
    archive(gone_to_, stamps_, sequence_, aside_sequence_);
  }

 private:
  void pushAside(Stamp stamp, std::uint64_t sequence, T value, Counters& counters) {
    if (aside_.size() >= capacity_ || (!aside_.empty() && stamp <= aside_.back().stamp)) {
      counters.add("late");
      return;
    }
    aside_.push_back({stamp, std::move(value)});
    aside_sequence_ = SequenceWatch(sequence);
    if (aside_.size() >= kInARow && returnsFromJump()) leaveFuture(counters);
  }

  /// To stamps that the receiver has not gone beyond.
  bool returnsFromJump() const {
    const auto first = aside_.front().stamp;
    return stamps_.begin() && first < *stamps_.begin() &&
           (!stamps_.before() || first > *stamps_.before()) && (!gone_to_ || first > *gone_to_);
  }

  void leaveFuture(Counters& counters) {
    while (!items_.empty() && items_.back().stamp >= *stamps_.begin()) {
      items_.pop_back();
      counters.add("stamp_jump");
    }
    for (auto& item : aside_) items_.push_back(std::move(item));
    aside_.clear();
    stamps_.forget(items_.back().stamp);
    sequence_ = aside_sequence_;
  }

  std::size_t capacity_;
  std::deque<Item> items_, aside_;
  std::optional<Stamp> gone_to_;
  StampJump stamps_;
  SequenceWatch sequence_, aside_sequence_;
};

}  // namespace slam
