// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/memory/persistent_array.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/particle_filter/particles/workers.hpp"

namespace slam::particle_filter {
namespace {

using Array = PersistentArray<int>;

Array arrayOf(Array::Memory& memory, int size) {
  Array array(memory);
  for (int i = 0; i < size; ++i) array.push_back(i);
  return array;
}

void expectEqual(const Array& array, const std::map<std::size_t, int>& reference) {
  ASSERT_EQ(array.size(), reference.size());
  for (const auto& [i, value] : reference) ASSERT_EQ(array[i], value) << "element " << i;
}

TEST(PersistentArray, IsLikeAMapUnderRandomCopiesAndWrites) {
  Array::Memory memory;
  RandomStream random(5, 0);
  std::vector<Array> arrays(6, Array(memory));
  std::vector<std::map<std::size_t, int>> references(6);
  const auto below = [&](std::size_t n) { return std::size_t(random.uniform() * double(n)); };
  for (int operation = 0; operation < 20000; ++operation) {
    const auto a = below(6), b = below(6);
    const int value = int(random.bits());
    if (random.uniform() < 0.05) {
      arrays[a] = arrays[b];
      references[a] = references[b];
    } else if (references[a].empty() || random.uniform() < 0.2) {
      references[a][arrays[a].size()] = value;
      arrays[a].push_back(value);
    } else {
      const auto i = below(references[a].size());
      arrays[a].edit(i) = value;
      references[a][i] = value;
    }
    if (operation % 500 == 0) expectEqual(arrays[a], references[a]);
  }
  for (std::size_t a = 0; a < 6; ++a) expectEqual(arrays[a], references[a]);
}

TEST(PersistentArray, SharesEverythingWithItsCopies) {
  Array::Memory memory;
  const auto array = arrayOf(memory, 1000);
  const auto leaves = memory.leavesInUse(), nodes = memory.nodesInUse();
  EXPECT_EQ(leaves, 250u) << "four elements each";
  const std::vector<Array> copies(100, array);
  EXPECT_EQ(memory.leavesInUse(), leaves);
  EXPECT_EQ(memory.nodesInUse(), nodes);
}

TEST(PersistentArray, CopiesOneBlockOfEachHeightForOneElement) {
  Array::Memory memory;
  for (const int size : {4, 32, 256, 2048, 16384}) {
    const auto array = arrayOf(memory, size);
    auto copy = array;
    const auto leaves = memory.leavesInUse(), nodes = memory.nodesInUse();
    copy.edit(std::size_t(size) / 2) = -1;
    const auto heights = std::size_t(std::lround(std::log(size / 4.0) / std::log(8.0)));
    EXPECT_EQ(memory.leavesInUse() - leaves, 1u);
    EXPECT_EQ(memory.nodesInUse() - nodes, heights);
    copy.edit(std::size_t(size) / 2 + 1) = -1;
    EXPECT_EQ(memory.leavesInUse() - leaves, 1u) << "its own block is written in place";
    EXPECT_EQ(array[std::size_t(size) / 2], size / 2);
  }
}

TEST(PersistentArray, GivesItsMemoryBack) {
  Array::Memory memory;
  {
    auto array = arrayOf(memory, 3000);
    std::vector<Array> copies(10, array);
    for (std::size_t i = 0; i < copies.size(); ++i) copies[i].edit(100 * i) = 0;
    array = Array(memory);
    EXPECT_GT(memory.leavesInUse(), 0u);
  }
  EXPECT_EQ(memory.leavesInUse(), 0u);
  EXPECT_EQ(memory.nodesInUse(), 0u);
  const auto reserved = memory.reservedBytes();
  for (int i = 0; i < 20; ++i) arrayOf(memory, 3000);
  EXPECT_EQ(memory.reservedBytes(), reserved) << "what is given back is used again";
}

TEST(PersistentArray, IsWrittenByManyThreads) {
  constexpr std::size_t kArrays = 64;
  Array::Memory memory(4);
  std::vector<Array> arrays(kArrays, arrayOf(memory, 500));
  Workers workers(4);
  for (int round = 0; round < 20; ++round) {
    workers.forEach(kArrays, [&](std::size_t a, unsigned lane) {
      for (std::size_t i = a % 7; i < 500; i += 7) arrays[a].edit(i, lane) += int(a);
      arrays[a].push_back(round, lane);
    });
    for (std::size_t a = 0; a < kArrays; a += 2) arrays[a] = arrays[a + 1];
  }
  EXPECT_EQ(arrays[63][63 % 7], int(63 % 7) + 20 * 63);
  EXPECT_EQ(arrays[62][63 % 7], arrays[63][63 % 7]);
  EXPECT_EQ(arrays[63][519], 19);
  arrays.clear();
  EXPECT_EQ(memory.leavesInUse(), 0u);
  EXPECT_EQ(memory.nodesInUse(), 0u);
}

TEST(PersistentArray, TakesNoMoreMemoryWhenOneThreadGivesBackWhatOthersTook) {
  constexpr std::size_t kArrays = 64, kSize = 400;
  constexpr unsigned kLanes = 4;
  Array::Memory memory(kLanes);
  Workers workers(kLanes);
  std::vector<Array> arrays(kArrays, arrayOf(memory, int(kSize)));
  std::size_t early = 0;
  for (int round = 0; round < 400; ++round) {
    workers.forEach(kArrays, [&](std::size_t a, unsigned lane) {
      for (std::size_t i = 0; i < kSize; ++i) arrays[a].edit(i, lane) += 1;
    });
    if (round == 20) early = memory.reservedBytes();
    arrays.assign(kArrays, arrays[std::size_t(round) % kArrays]);
  }
  EXPECT_LE(memory.reservedBytes(), early + kLanes * 4 * (1u << 16))
      << "two batches a lane and pool";
}

}  // namespace
}  // namespace slam::particle_filter
