// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <utility>
#include <vector>

namespace slam::sim {

/// Results of tasks that are worked on by some threads at once, taken in the tasks' order.
template <class Result>
class OrderedTasks {
 public:
  using Task = std::function<Result()>;

  OrderedTasks(std::vector<Task> tasks, unsigned threads)
      : tasks_(std::move(tasks)), threads_(threads < 1 ? 1 : threads) {}

  /// The result of the next task; throws what the task has thrown.
  Result next() {
    start(threads_);
    auto result = running_.front().get();
    running_.pop_front();
    start(threads_);  // works on while the caller uses the result
    return result;
  }

 private:
  void start(unsigned at_once) {
    for (; running_.size() < at_once && started_ < tasks_.size(); ++started_)
      running_.push_back(std::async(std::launch::async, tasks_[started_]));
  }

  std::vector<Task> tasks_;
  unsigned threads_;
  std::size_t started_ = 0;
  std::deque<std::future<Result>> running_;
};

}  // namespace slam::sim
