// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/workers.hpp"

#include <system_error>
#include <utility>

namespace slam::particle_filter {

Workers::Workers(unsigned lanes) {
  threads_.reserve(lanes);
  try {
    for (unsigned lane = 1; lane < lanes; ++lane)
      threads_.emplace_back([this, lane] { serve(lane); });
  } catch (const std::system_error&) {
    // those that were started do all the work: what comes of it does not depend on their number
  }
}

Workers::~Workers() {
  {
    const std::lock_guard<std::mutex> lock(lock_);
    ends_ = true;
  }
  begun_.notify_all();
  for (auto& thread : threads_) thread.join();
}

void Workers::runOnAllLanes(const Part& part) {
  if (!threads_.empty()) {
    const std::lock_guard<std::mutex> lock(lock_);
    part_ = &part;
    busy_ = threads_.size();
    ++round_;
  }
  begun_.notify_all();
  attempt(part, 0);
  std::unique_lock<std::mutex> lock(lock_);
  done_.wait(lock, [this] { return busy_ == 0; });
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

/// What a thread of its own let out would end the program.
void Workers::attempt(const Part& part, unsigned lane) {
  try {
    part(lane);
  } catch (...) {
    const std::lock_guard<std::mutex> lock(lock_);
    thrown_ = std::current_exception();
  }
}

void Workers::serve(unsigned lane) {
  std::unique_lock<std::mutex> lock(lock_);
  for (std::uint64_t served = 0;;) {
    begun_.wait(lock, [&] { return ends_ || round_ != served; });
    if (ends_) return;
    served = round_;
    const Part& part = *part_;
    lock.unlock();
    attempt(part, lane);
    lock.lock();
    if (--busy_ == 0) done_.notify_one();
  }
}

}  // namespace slam::particle_filter
