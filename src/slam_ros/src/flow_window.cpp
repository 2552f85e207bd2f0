// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/flow_window.hpp"

#include <algorithm>

namespace slam_ros {

void FlowWindow::limit(const std::string& input, std::size_t capacity) {
  const std::lock_guard<std::mutex> lock(mutex_);
  limits_[input] = capacity;
}

void FlowWindow::sent(const std::string& input, slam::Stamp stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  sent_[input].push_back(stamp);
}

void FlowWindow::acknowledged(const std::string& input, slam::Stamp up_to) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto& stamps = sent_[input];
  bool any = false;
  for (; !stamps.empty() && stamps.front() <= up_to; any = true) stamps.pop_front();
  if (!any) return;
  ++acknowledgements_;
  changed_.notify_all();
}

bool FlowWindow::waitForRoom(const std::string& input, Timeout patience) {
  return waitFor([&] { return sent_[input].size() < capacityOf(input); }, patience);
}

bool FlowWindow::waitForAllBefore(slam::Stamp stamp, Timeout patience) {
  const auto has_come = [stamp](const auto& entry) {
    return entry.second.empty() || entry.second.front() >= stamp;
  };
  return waitFor([&] { return std::all_of(sent_.begin(), sent_.end(), has_come); }, patience);
}

bool FlowWindow::waitUntilEmpty(Timeout patience) {
  return waitFor([&] { return sum() == 0; }, patience);
}

template <class Condition>
bool FlowWindow::waitFor(Condition condition, Timeout patience) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopped_ && !condition()) {
    const auto before = acknowledgements_;
    changed_.wait_for(lock, patience,
                      [&] { return stopped_ || acknowledgements_ != before || condition(); });
    if (acknowledgements_ == before && !condition()) return false;
  }
  return !stopped_;
}

void FlowWindow::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  sent_.clear();
}

std::size_t FlowWindow::inFlight() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return sum();
}

std::size_t FlowWindow::sum() const {
  std::size_t sum = 0;
  for (const auto& entry : sent_) sum += entry.second.size();
  return sum;
}

std::size_t FlowWindow::capacityOf(const std::string& input) const {
  const auto limit = limits_.find(input);
  return limit == limits_.end() ? capacity_ : limit->second;
}

void FlowWindow::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

}  // namespace slam_ros
