// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/memory/block_pool.hpp"

#include <algorithm>
#include <utility>

namespace slam::particle_filter {
namespace {

constexpr std::size_t kSlabBytes = 1 << 16;

/// Every block of a slab can hold `smallest` bytes while it is free.
std::size_t roomFor(std::size_t block_bytes, std::size_t smallest) {
  constexpr std::size_t kAlignment = alignof(void*);
  const auto bytes = std::max(block_bytes, smallest);
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

}  // namespace

BlockPool::BlockPool(std::size_t block_bytes, unsigned lanes)
    : block_bytes_(roomFor(block_bytes, sizeof(FreeBlock))),
      batch_(std::max<std::size_t>(1, kSlabBytes / block_bytes_)),
      lanes_(lanes) {}

void* BlockPool::allocate(unsigned lane) {
  auto& own = lanes_[lane];
  if (own.free == nullptr) {
    own.free = own.spare != nullptr ? std::exchange(own.spare, nullptr) : takeBatch();
    own.count = batch_;
  }
  auto* block = own.free;
  own.free = block->next;
  __builtin_prefetch(own.free, 1);  // the next one will be written, and tells the one after it
  --own.count;
  ++own.in_use;
  return block;
}

void BlockPool::release(void* block, unsigned lane) {
  auto& own = lanes_[lane];
  own.free = new (block) FreeBlock{own.free, nullptr};
  --own.in_use;
  if (++own.count < batch_) return;
  auto* const full = std::exchange(own.free, nullptr);
  own.count = 0;
  if (own.spare == nullptr) {
    own.spare = full;
    return;
  }
  const std::lock_guard<std::mutex> lock(depot_lock_);
  full->next_batch = std::exchange(depot_, full);
}

BlockPool::FreeBlock* BlockPool::takeBatch() {
  const std::lock_guard<std::mutex> lock(depot_lock_);
  if (depot_ == nullptr) return newBatch();
  return std::exchange(depot_, depot_->next_batch);
}

BlockPool::FreeBlock* BlockPool::newBatch() {
  slabs_.push_back(std::make_unique<std::byte[]>(block_bytes_ * batch_));
  std::byte* const slab = slabs_.back().get();
  FreeBlock* first = nullptr;
  for (std::size_t i = batch_; i-- > 0;)  // handed out in the order of addresses
    first = new (slab + i * block_bytes_) FreeBlock{first, nullptr};
  return first;
}

std::size_t BlockPool::inUse() const {
  std::int64_t sum = 0;
  for (const auto& lane : lanes_) sum += lane.in_use;
  return static_cast<std::size_t>(sum);
}

}  // namespace slam::particle_filter
