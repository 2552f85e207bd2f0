// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace slam::particle_filter {

/// Threads that are started once and joined with this. For one caller, who is lane 0.
class Workers {
 public:
  /// The system may grant fewer lanes.
  explicit Workers(unsigned lanes);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// Calls work(i, lane) for each i below `count`, each lane with a contiguous part of its own;
  /// returns when all are done. What `work` throws comes out here then, of several lanes one's.
  template <class Work>
  void forEach(std::size_t count, const Work& work) {
    runOnAllLanes([&](unsigned lane) {
      const std::size_t lanes = threads_.size() + 1;
      for (std::size_t i = count * lane / lanes; i < count * (lane + 1) / lanes; ++i) work(i, lane);
    });
  }

 private:
  using Part = std::function<void(unsigned lane)>;

  void runOnAllLanes(const Part& part);
  void attempt(const Part& part, unsigned lane);
  void serve(unsigned lane);

  std::mutex lock_;
  std::condition_variable begun_, done_;
  const Part* part_ = nullptr;
  std::uint64_t round_ = 0;
  std::size_t busy_ = 0;
  std::exception_ptr thrown_;  ///< on some lane in this round
  bool ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace slam::particle_filter
