// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace slam::particle_filter {

/// Memory for very many blocks of one size. Each lane belongs to one thread at a time and has its
/// own free list, so that no lock is needed; a block may be given back on another lane than it came
/// from. The memory itself goes back with the pool.
class BlockPool {
 public:
  explicit BlockPool(std::size_t block_bytes, unsigned lanes = 1);

  void* allocate(unsigned lane);
  void release(void* block, unsigned lane);

  /// Blocks that are allocated now; not while threads are at work.
  std::size_t inUse() const;
  std::size_t reservedBytes() const;

 private:
  struct FreeBlock {
    FreeBlock* next;
  };
  struct alignas(64) Lane {  // a cache line each: threads do not disturb one another
    FreeBlock* free = nullptr;
    std::int64_t in_use = 0;
    std::vector<std::unique_ptr<std::byte[]>> slabs;
  };

  void refill(Lane& lane);

  std::size_t block_bytes_, blocks_per_slab_;
  std::vector<Lane> lanes_;
};

}  // namespace slam::particle_filter
