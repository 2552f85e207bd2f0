// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/workers.hpp"

#include <gtest/gtest.h>

#include <set>

namespace slam::particle_filter {
namespace {

TEST(Workers, DoEachOnce) {
  for (const unsigned lanes : {1u, 2u, 3u, 8u}) {
    Workers workers(lanes);
    for (const std::size_t count : {0u, 1u, 5u, 100u}) {
      std::vector<int> done(count, 0);
      workers.forEach(count, [&](std::size_t i, unsigned lane) {
        EXPECT_LT(lane, lanes);
        ++done[i];
      });
      EXPECT_EQ(done, std::vector<int>(count, 1));
    }
  }
}

TEST(Workers, AreTheSameThreadsEachTime) {
  constexpr unsigned kLanes = 4;
  Workers workers(kLanes);
  std::set<std::thread::id> threads;
  std::mutex lock;
  for (int round = 0; round < 100; ++round)
    workers.forEach(kLanes, [&](std::size_t, unsigned) {
      const std::lock_guard<std::mutex> guard(lock);
      threads.insert(std::this_thread::get_id());
    });
  EXPECT_EQ(threads.size(), kLanes);
}

TEST(Workers, HandOnWhatTheWorkThrowsAndGoOn) {
  constexpr unsigned kLanes = 4;
  Workers workers(kLanes);
  for (std::size_t culprit = 0; culprit < kLanes; ++culprit) {
    const auto fail = [&](std::size_t i, unsigned) {
      if (i == culprit) throw std::bad_alloc();
    };
    EXPECT_THROW(workers.forEach(kLanes, fail), std::bad_alloc);
    int done = 0;
    workers.forEach(1, [&](std::size_t, unsigned) { ++done; });
    EXPECT_EQ(done, 1);
  }
}

}  // namespace
}  // namespace slam::particle_filter
