// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "slam_core/common/reference_count.hpp"
#include "slam_core/particle_filter/memory/block_pool.hpp"

namespace slam::particle_filter {

/// An array whose copies share all they have in common: copying takes a pointer, and writing an
/// element copies the O(log size) blocks on the way to it that others hold, too (path copying,
/// Driscoll, Sarnak, Sleator, Tarjan 1989; the tree of maps of Montemerlo 2003, ch. 3, with wider
/// nodes). Blocks nobody else holds are written in place.
///
/// Threads may write different arrays at the same time, each with its own lane, when the memory
/// was made for several lanes. Copying, assigning and destroying happens on one thread only.
template <class T>
class PersistentArray {
  static_assert(std::is_trivially_copyable_v<T>);

  static constexpr unsigned kLeafBits = 2, kFanBits = 3;
  static constexpr std::size_t kTogether = 64;
  static constexpr std::size_t kLeafSize = 1 << kLeafBits, kFanOut = 1 << kFanBits;

  struct Block {
    ReferenceCount count;
  };
  struct Leaf : Block {
    std::array<T, kLeafSize> values;
  };
  struct Node : Block {
    std::array<Block*, kFanOut> children{};
  };

 public:
  /// Shared by all arrays that may share their elements; must outlive them.
  class Memory {
   public:
    explicit Memory(unsigned lanes = 1)
        : leaves_(sizeof(Leaf), lanes), nodes_(sizeof(Node), lanes), concurrent_(lanes > 1) {}
    std::size_t leavesInUse() const { return leaves_.inUse(); }
    std::size_t nodesInUse() const { return nodes_.inUse(); }
    std::size_t reservedBytes() const { return leaves_.reservedBytes() + nodes_.reservedBytes(); }

   private:
    friend class PersistentArray;
    BlockPool leaves_, nodes_;
    bool concurrent_;
  };

  explicit PersistentArray(Memory& memory) : memory_(&memory) {}
  PersistentArray(const PersistentArray& other)
      : memory_(other.memory_), root_(other.root_), size_(other.size_), height_(other.height_) {
    if (root_ != nullptr) root_->count.increment(memory_->concurrent_);
  }
  PersistentArray(PersistentArray&& other) noexcept
      : memory_(other.memory_),
        root_(std::exchange(other.root_, nullptr)),
        size_(std::exchange(other.size_, 0)),
        height_(std::exchange(other.height_, 0)) {}
  PersistentArray& operator=(PersistentArray other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(root_, other.root_);
    std::swap(size_, other.size_);
    std::swap(height_, other.height_);
    return *this;
  }
  ~PersistentArray() { drop(root_, height_, 0); }

  std::size_t size() const { return size_; }

  const T& operator[](std::size_t i) const {
    const Block* block = root_;
    for (unsigned height = height_; height > 0; --height)
      block = static_cast<const Node*>(block)->children[childAt(i, height)];
    return static_cast<const Leaf*>(block)->values[i % kLeafSize];
  }

  /// Has the elements fetched from memory that will be read next: what is far away in memory comes
  /// for all of them at the same time, one height of the tree after the other.
  /// @param matches with a `slot` each, which is the number of the element
  template <class Match>
  void prefetch(const std::vector<Match>& matches) const {
    std::array<const Block*, kTogether> blocks;
    for (std::size_t first = 0; first < matches.size(); first += kTogether) {
      const auto count = std::min(kTogether, matches.size() - first);
      blocks.fill(root_);
      for (unsigned height = height_; height > 0; --height) {
        for (std::size_t k = 0; k < count; ++k) {
          const auto slot = matches[first + k].slot;
          blocks[k] = static_cast<const Node*>(blocks[k])->children[childAt(slot, height)];
          __builtin_prefetch(blocks[k]);
          if (height > 1)
            __builtin_prefetch(
                &static_cast<const Node*>(blocks[k])->children[childAt(slot, height - 1)]);
          else
            __builtin_prefetch(&static_cast<const Leaf*>(blocks[k])->values[slot % kLeafSize]);
        }
      }
    }
  }

  /// The element for writing, no longer shared with other arrays; valid until one is copied.
  T& edit(std::size_t i, unsigned lane = 0) {
    Block** link = &root_;
    for (unsigned height = height_; height > 0; --height)
      link = &ownNode(link, height, lane)->children[childAt(i, height)];
    return ownLeaf(link, lane)->values[i % kLeafSize];
  }

  void push_back(const T& value, unsigned lane = 0) {
    if (root_ != nullptr && size_ == capacity(height_)) {
      auto* const root = newNode(lane);
      root->children[0] = std::exchange(root_, root);
      ++height_;
    }
    edit(size_++, lane) = value;
  }

  template <class Archive>
  void persist(Archive& archive) {
    constexpr unsigned kMostHeight = 20;
    if constexpr (Archive::kReads) *this = PersistentArray(*memory_);
    auto height = height_;
    auto size = std::uint64_t{size_};
    archive(height, size);
    if constexpr (Archive::kReads) {
      if (height > kMostHeight || size > capacity(height))
        throw std::runtime_error("it holds an array of another size: save it again");
      height_ = height;
    }
    persistBlock(archive, root_, height);
    size_ = size;
  }

 private:
  static std::size_t capacity(unsigned height) {
    return std::size_t{1} << (kLeafBits + kFanBits * height);
  }
  static std::size_t childAt(std::size_t i, unsigned height) {
    return (i >> (kLeafBits + kFanBits * (height - 1))) % kFanOut;
  }

  template <class Archive>
  void persistBlock(Archive& archive, Block*& block, unsigned height) {
    if (height == 0)
      persistAs<Leaf>(archive, block, memory_->leaves_, [&](Leaf& leaf) { archive(leaf.values); });
    else
      persistAs<Node>(archive, block, memory_->nodes_, [&](Node& node) {
        for (auto& child : node.children) persistBlock(archive, child, height - 1);
      });
  }
  template <class Kind, class Archive, class Persist>
  void persistAs(Archive& archive, Block*& block, BlockPool& pool, const Persist& persist) {
    auto* kind = static_cast<Kind*>(block);
    const bool follows = archive.refer(kind);
    if constexpr (Archive::kReads) {
      if (follows) archive.bind(kind = new (pool.allocate(0)) Kind());
      block = kind;
      if (!follows && block != nullptr) block->count.increment(memory_->concurrent_);
    }
    if (follows) persist(*kind);
  }

  Node* newNode(unsigned lane) { return new (memory_->nodes_.allocate(lane)) Node(); }

  /// The block at a link, made if there is none, copied if others hold it.
  Node* ownNode(Block** link, unsigned height, unsigned lane) {
    auto* const old = static_cast<Node*>(*link);
    if (old == nullptr) return static_cast<Node*>(*link = newNode(lane));
    if (old->count.isOne()) return old;
    auto* const copy = newNode(lane);
    copy->children = old->children;
    for (auto* child : copy->children)
      if (child != nullptr) child->count.increment(memory_->concurrent_);
    drop(old, height, lane);
    return static_cast<Node*>(*link = copy);
  }

  Leaf* ownLeaf(Block** link, unsigned lane) {
    auto* const old = static_cast<Leaf*>(*link);
    if (old != nullptr && old->count.isOne()) return old;
    auto* const copy = new (memory_->leaves_.allocate(lane)) Leaf();
    if (old != nullptr) {
      copy->values = old->values;
      drop(old, 0, lane);
    }
    return static_cast<Leaf*>(*link = copy);
  }

  void drop(Block* block, unsigned height, unsigned lane) {
    if (block == nullptr || !block->count.decrement(memory_->concurrent_)) return;
    if (height == 0) {
      memory_->leaves_.release(block, lane);
      return;
    }
    for (auto* child : static_cast<Node*>(block)->children) drop(child, height - 1, lane);
    memory_->nodes_.release(block, lane);
  }

  Memory* memory_;
  Block* root_ = nullptr;
  std::size_t size_ = 0;
  unsigned height_ = 0;  ///< 0: the root is a leaf
};

}  // namespace slam::particle_filter
