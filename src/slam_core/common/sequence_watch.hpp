// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// Counts the messages that a source's sequence numbers show as lost. A number that goes back, or
/// that is further ahead than any source can have sent meanwhile, tells of no loss: the source was
/// restarted, or the number is damaged and the next messages go on from those before it.
class SequenceWatch {
 public:
  SequenceWatch() = default;
  /// The watch begins after a message of that number.
  explicit SequenceWatch(std::uint64_t sequence) : next_(sequence + 1) {}

  /// How many messages were lost before this one. @param interval since the message before it
  std::uint64_t lostBefore(std::uint64_t sequence, Duration interval) {
    const auto most = static_cast<std::uint64_t>(kMostPerSecond * (1.0 + seconds(interval)));
    auto lost = gapTo(next_, sequence, most);
    if (next_ && !lost && !before_break_) {
      before_break_ = next_;
      since_break_ = 0;
    }
    if (before_break_) {
      const auto unbroken = gapTo(*before_break_ + since_break_, sequence, most);
      const bool was_damaged = unbroken && (!lost || *unbroken < *lost);
      if (was_damaged) lost = unbroken;
      if (was_damaged || ++since_break_ > kDamaged) before_break_.reset();
    }
    next_ = sequence + 1;
    return lost.value_or(0);
  }

  /// A message that is dropped for another reason.
  void skip(std::uint64_t sequence) {
    if (next_ == sequence) ++*next_;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(next_, before_break_, since_break_);
  }

 private:
  static constexpr double kMostPerSecond = 10000.0;
  static constexpr std::uint64_t kDamaged =
      10;  ///< numbers in a row; then the source was restarted

  static std::optional<std::uint64_t> gapTo(const std::optional<std::uint64_t>& next,
                                            std::uint64_t sequence, std::uint64_t most) {
    if (!next || sequence < *next || sequence - *next > most) return std::nullopt;
    return sequence - *next;
  }

  std::optional<std::uint64_t> next_;
  std::optional<std::uint64_t> before_break_;  ///< what was next when the numbers broke off
  std::uint64_t since_break_ = 0;              ///< messages
};

}  // namespace slam
