// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/block_pool.hpp"

#include <algorithm>

namespace slam::particle_filter {
namespace {

constexpr std::size_t kSlabBytes = 1 << 16;

/// Every block of a slab can hold a pointer while it is free.
std::size_t roomFor(std::size_t block_bytes) {
  constexpr std::size_t kAlignment = alignof(void*);
  const auto bytes = std::max(block_bytes, sizeof(void*));
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

}  // namespace

BlockPool::BlockPool(std::size_t block_bytes, unsigned lanes)
    : block_bytes_(roomFor(block_bytes)),
      blocks_per_slab_(std::max<std::size_t>(1, kSlabBytes / block_bytes_)),
      lanes_(lanes) {}

void* BlockPool::allocate(unsigned lane) {
  auto& own = lanes_[lane];
  if (own.free == nullptr) refill(own);
  auto* block = own.free;
  own.free = block->next;
  ++own.in_use;
  return block;
}

void BlockPool::release(void* block, unsigned lane) {
  auto& own = lanes_[lane];
  own.free = new (block) FreeBlock{own.free};
  --own.in_use;
}

void BlockPool::refill(Lane& lane) {
  lane.slabs.push_back(std::make_unique<std::byte[]>(block_bytes_ * blocks_per_slab_));
  std::byte* const slab = lane.slabs.back().get();
  for (std::size_t i = blocks_per_slab_; i-- > 0;)  // handed out in the order of addresses
    lane.free = new (slab + i * block_bytes_) FreeBlock{lane.free};
}

std::size_t BlockPool::inUse() const {
  std::int64_t sum = 0;
  for (const auto& lane : lanes_) sum += lane.in_use;
  return static_cast<std::size_t>(sum);
}

std::size_t BlockPool::reservedBytes() const {
  std::size_t slabs = 0;
  for (const auto& lane : lanes_) slabs += lane.slabs.size();
  return slabs * blocks_per_slab_ * block_bytes_;
}

}  // namespace slam::particle_filter
