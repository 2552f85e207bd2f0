// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace slam::particle_filter {

/// Memory for very many blocks of one size. Each lane belongs to one thread at a time and has free
/// blocks of its own, two batches at most, so that a lock is needed once a batch only; what goes
/// beyond that is there for all lanes (the magazines and the depot of Bonwick, Adams 2001). So a
/// block may be given back on another lane than it came from, and all of them on the same. The
/// memory itself goes back with the pool.
class BlockPool {
 public:
  explicit BlockPool(std::size_t block_bytes, unsigned lanes = 1);

  void* allocate(unsigned lane);
  void release(void* block, unsigned lane);

  /// Blocks that are allocated now; not while threads are at work.
  std::size_t inUse() const;
  std::size_t reservedBytes() const { return slabs_.size() * batch_ * block_bytes_; }

 private:
  struct FreeBlock {
    FreeBlock* next;
    FreeBlock* next_batch;  ///< of the first block of a batch in the depot
  };
  struct alignas(64) Lane {  // a cache line each: threads do not disturb one another
    FreeBlock* free = nullptr;
    FreeBlock* spare = nullptr;  ///< a whole batch, or none
    std::size_t count = 0;       ///< of the free ones, at most a batch
    std::int64_t in_use = 0;
  };

  FreeBlock* takeBatch();
  FreeBlock* newBatch();

  std::size_t block_bytes_, batch_;  ///< blocks in a batch, which is what a slab holds
  std::vector<Lane> lanes_;
  std::mutex depot_lock_;
  FreeBlock* depot_ = nullptr;
  std::vector<std::unique_ptr<std::byte[]>> slabs_;
};

}  // namespace slam::particle_filter
