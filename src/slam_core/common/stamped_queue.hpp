// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/sequence_watch.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// The bounded queue of one source, in the order of stamps. What is not newer than the last one is
/// dropped as "late"; what is older by more than kStampJump may be the beginning of a new run and
/// is kept aside until the other sources tell.
///
/// Stamps that jump ahead by more than kStampJump may be wrong: one of them is dropped as
/// "stamp_jump" when the next one did not jump, several of them once kInARow messages in a row have
/// stamps from before the jump, unless the receiver has already gone beyond those (goneTo()).
template <class T>
class StampedQueue {
 public:
  struct Item {
    Stamp stamp;
    T value;
  };
  /// Messages that together are believed, where one alone is not.
  static constexpr std::size_t kInARow = 3;
  /// A jump ahead is believed when the messages behind it cover as much.
  static constexpr Duration kBelieved = std::chrono::seconds(1);

  explicit StampedQueue(std::size_t capacity = 1000) : capacity_(capacity) {}

  void push(Stamp stamp, std::uint64_t sequence, T value, Counters& counters) {
    if (lastWasWrong(stamp)) {
      items_.pop_back();
      last_ = jump_->before;
      forgetJump();
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
      sequence_.skip(sequence);  // late, not lost as well
      return;
    }
    counters.add("late", aside_.size());
    aside_.clear();
    counters.add("lost", sequence_.lostBefore(sequence, last_ ? stamp - *last_ : Duration()));
    noteJump(stamp);
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

  /// The receiver is done with all up to here and cannot take older messages any more.
  void goneTo(Stamp stamp) { gone_to_ = stamp; }

  bool empty() const { return items_.empty(); }
  std::size_t size() const { return items_.size(); }
  const Item& front() const { return items_.front(); }
  const Item& operator[](std::size_t index) const { return items_[index]; }
  /// The newest stamp accepted, whether or not it is still held.
  std::optional<Stamp> last() const { return last_; }
  /// The same without a jump ahead that too few messages have confirmed.
  std::optional<Stamp> believed() const {
    return jump_ && jump_->is_doubtful && !isConfirmed(*jump_) ? jump_->before : last_;
  }
  bool wentBack() const { return !aside_.empty(); }
  /// The same where it is not the end of a jump ahead that nothing has come of.
  bool beganAnew() const { return wentBack() && !(jump_ && jump_->before && returnsFromJump()); }
  /// Where the last jump ahead led to.
  std::optional<Stamp> jump() const { return jump_ ? std::optional(jump_->begin) : std::nullopt; }
  /// Messages that wait to be told whether they begin a new run.
  std::size_t setAside() const { return aside_.size(); }

  /// Forgets the old run and goes on with what was kept aside.
  void restart() {
    items_ = std::exchange(aside_, {});
    last_.reset();
    forgetJump();
    gone_to_.reset();
    if (!items_.empty()) last_ = items_.back().stamp;
    sequence_ = aside_sequence_;
  }

 private:
  /// From `before`, nothing where the source begins, to `begin`.
  struct Jump {
    std::optional<Stamp> before;
    Stamp begin;
    std::size_t messages = 1;  ///< since then
    bool is_doubtful = false;
  };

  bool isConfirmed(const Jump& jump) const {
    return jump.messages >= kInARow && *last_ - jump.begin >= kBelieved;
  }

  /// Intervals like the last one are no reason for doubt: the source is slow.
  void noteJump(Stamp stamp) {
    const auto interval = last_ ? std::optional(stamp - *last_) : std::nullopt;
    const bool is_jump = !interval || *interval > kStampJump;
    if (is_jump && (!jump_ || !jump_->before || isConfirmed(*jump_)))
      jump_ =
          Jump{last_, stamp, 1, interval && (!last_interval_ || *interval > 2 * *last_interval_)};
    else if (jump_)
      ++jump_->messages;
    last_interval_ = interval;
  }

  void forgetJump() {
    jump_.reset();
    last_interval_.reset();
  }

  bool lastWasWrong(Stamp stamp) const {
    return jump_ && jump_->before && jump_->messages == 1 && !items_.empty() &&
           *jump_->before < stamp && stamp < *last_ && aside_.empty();
  }

  void pushAside(Stamp stamp, std::uint64_t sequence, T value, Counters& counters) {
    if (aside_.size() >= capacity_ || (!aside_.empty() && stamp <= aside_.back().stamp)) {
      counters.add("late");
      return;
    }
    aside_.push_back({stamp, std::move(value)});
    aside_sequence_ = SequenceWatch(sequence);
    if (jump_ && aside_.size() >= kInARow && returnsFromJump()) leaveFuture(counters);
  }

  /// To stamps that the receiver has not gone beyond.
  bool returnsFromJump() const {
    const auto first = aside_.front().stamp;
    return first < jump_->begin && (!jump_->before || first > *jump_->before) &&
           (!gone_to_ || first > *gone_to_);
  }

  void leaveFuture(Counters& counters) {
    while (!items_.empty() && items_.back().stamp >= jump_->begin) {
      items_.pop_back();
      counters.add("stamp_jump");
    }
    for (auto& item : aside_) items_.push_back(std::move(item));
    aside_.clear();
    last_ = items_.back().stamp;
    forgetJump();
    sequence_ = aside_sequence_;
  }

  std::size_t capacity_;
  std::deque<Item> items_, aside_;
  std::optional<Stamp> last_, gone_to_;
  std::optional<Duration> last_interval_;
  std::optional<Jump> jump_;  ///< the last one, as far as it may turn out to be wrong
  SequenceWatch sequence_, aside_sequence_;
};

}  // namespace slam
