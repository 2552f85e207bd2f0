// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// Watches the stamps that one source sends for a jump ahead by more than kStampJump, which may be
/// wrong. The last jump is remembered until the messages behind it confirm it.
class StampJump {
 public:
  /// Messages that together are believed, where one alone is not.
  static constexpr std::size_t kInARow = 3;
  /// A jump ahead is believed when the messages behind it cover as much.
  static constexpr Duration kBelieved = std::chrono::seconds(1);

  /// A message has come in order. Intervals like the last one are no reason for doubt: the source
  /// is slow.
  void note(Stamp stamp) {
    const auto interval = last_ ? std::optional(stamp - *last_) : std::nullopt;
    const bool is_jump = !interval || *interval > kStampJump;
    if (is_jump && (!jump_ || !jump_->before || isConfirmed()))
      jump_ =
          Jump{last_, stamp, 1, interval && (!last_interval_ || *interval > 2 * *last_interval_)};
    else if (jump_)
      ++jump_->messages;
    last_interval_ = interval;
    last_ = stamp;
  }

  /// The jump is not one: the source goes on from `last`, from nothing where it starts over.
  void forget(std::optional<Stamp> last = std::nullopt) {
    jump_.reset();
    last_interval_.reset();
    last_ = last;
  }

  /// Where the last jump ahead led to; nothing where there was none.
  std::optional<Stamp> begin() const { return jump_ ? std::optional(jump_->begin) : std::nullopt; }
  /// The stamp before it; nothing where the source began with it.
  std::optional<Stamp> before() const { return jump_ ? jump_->before : std::nullopt; }
  /// The newest stamp, whether or not its message is still held.
  std::optional<Stamp> last() const { return last_; }
  /// The same without a jump ahead that too few messages have confirmed.
  std::optional<Stamp> believed() const {
    return jump_ && jump_->is_doubtful && !isConfirmed() ? jump_->before : last_;
  }
  /// Whether a message of this stamp tells that the last one, which alone jumped ahead, was wrong:
  /// one that has not jumped itself. Behind a pause messages may come in another order.
  bool isRefutedBy(Stamp stamp) const {
    return before() && jump_->messages == 1 && *before() < stamp && stamp < *last_ &&
           stamp <= *before() + kStampJump;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_, last_interval_, jump_);
  }

 private:
  /// From `before`, nothing where the source begins, to `begin`.
  struct Jump {
    std::optional<Stamp> before;
    Stamp begin;
    std::size_t messages = 1;  ///< since then
    bool is_doubtful = false;

    template <class Archive>
    void persist(Archive& archive) {
      archive(before, begin, messages, is_doubtful);
    }
  };

  bool isConfirmed() const {
    return jump_->messages >= kInARow && *last_ - jump_->begin >= kBelieved;
  }

  std::optional<Stamp> last_;
  std::optional<Duration> last_interval_;
  std::optional<Jump> jump_;  ///< the last one, as far as it may turn out to be wrong
};

}  // namespace slam
