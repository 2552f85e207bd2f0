// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <thread>
#include <vector>

namespace slam::particle_filter {

/// Calls work(i, lane) for each i below `count` on `lanes` threads, each with a contiguous part of
/// its own; returns when all are done. The caller is lane 0. `work` must not throw.
template <class Work>
void forEachInParallel(std::size_t count, unsigned lanes, const Work& work) {
  const auto part = [&](unsigned lane) {
    for (std::size_t i = count * lane / lanes; i < count * (lane + 1) / lanes; ++i) work(i, lane);
  };
  std::vector<std::thread> threads;
  for (unsigned lane = 1; lane < lanes; ++lane) threads.emplace_back(part, lane);
  part(0);
  for (auto& thread : threads) thread.join();
}

}  // namespace slam::particle_filter
