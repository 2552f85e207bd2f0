// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <type_traits>
#include <utility>

#include "slam_core/common/reference_count.hpp"

namespace slam::grid_map {

/// A value whose copies are one until one of them is written. Different copies may be used on
/// different threads at the same time.
template <class T>
class CopyOnWrite {
  struct Block {
    ReferenceCount count;
    T value;
  };

 public:
  CopyOnWrite() = default;  ///< no value
  CopyOnWrite(const CopyOnWrite& other) : block_(other.block_) {
    if (block_ != nullptr) block_->count.increment(true);
  }
  CopyOnWrite(CopyOnWrite&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  CopyOnWrite& operator=(CopyOnWrite other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~CopyOnWrite() {
    if (block_ != nullptr && block_->count.decrement(true)) delete block_;
  }

  /// Null where there is no value.
  const T* get() const { return block_ == nullptr ? nullptr : &block_->value; }

  /// For writing, no longer shared with other copies; made of `arguments` where there is none.
  template <class... Arguments>
  T& own(Arguments&... arguments) {
    if (block_ == nullptr)
      block_ = new Block{ReferenceCount(), T(arguments...)};
    else if (!block_->count.isOne())
      *this = CopyOnWrite(new Block{ReferenceCount(), block_->value});
    return block_->value;
  }

  /// @param arguments of the persist() of the value, and of its constructor where that takes them
  template <class Archive, class... Arguments>
  void persist(Archive& archive, Arguments&... arguments) {
    if constexpr (Archive::kReads) *this = CopyOnWrite();
    if (!archive.refer(block_)) {
      if constexpr (Archive::kReads)
        if (block_ != nullptr) block_->count.increment(true);
      return;
    }
    if constexpr (Archive::kReads) {
      if constexpr (std::is_constructible_v<T, Arguments&...>)
        own(arguments...);
      else
        own();
      archive.bind(block_);
    }
    block_->value.persist(archive, arguments...);
  }

 private:
  explicit CopyOnWrite(Block* block) : block_(block) {}

  Block* block_ = nullptr;
};

}  // namespace slam::grid_map
