// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstdint>

namespace slam {

/// How many hold a block. Where only one thread is at work (concurrent = false) the operations are
/// plain loads and stores, an order of magnitude cheaper than atomic ones.
class ReferenceCount {
 public:
  explicit ReferenceCount(std::uint32_t count = 1) : count_(count) {}

  /// Whoever holds the only reference may write: nobody else can get hold of one.
  bool isOne() const { return count_.load(std::memory_order_acquire) == 1; }

  void increment(bool concurrent) {
    if (concurrent)
      count_.fetch_add(1, std::memory_order_relaxed);
    else
      count_.store(count_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  /// Whether that was the last reference.
  bool decrement(bool concurrent) {
    if (concurrent) return count_.fetch_sub(1, std::memory_order_acq_rel) == 1;
    const auto left = count_.load(std::memory_order_relaxed) - 1;
    count_.store(left, std::memory_order_relaxed);
    return left == 0;
  }

 private:
  std::atomic<std::uint32_t> count_;
};

}  // namespace slam
