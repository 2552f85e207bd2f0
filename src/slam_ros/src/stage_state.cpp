// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/stage_state.hpp"

#include <map>
#include <utility>

namespace slam_ros {

std::shared_ptr<StageState> StageState::of(const std::string& product, const std::string& stage) {
  static std::mutex mutex;
  static std::map<std::pair<std::string, std::string>, std::weak_ptr<StageState>> all;
  const std::lock_guard<std::mutex> lock(mutex);
  auto& known = all[{product, stage}];
  auto state = known.lock();
  if (!state) known = state = std::make_shared<StageState>();
  return state;
}

void StageState::open(slam::MetaCoordinator& part, bool has_checkpoints) {
  const std::lock_guard<std::mutex> lock(mutex_);
  part_ = &part;
  has_checkpoints_ = has_checkpoints;
  fresh_ = slam::stateOf(part);
  // a nodelet that is loaded again beside a back-end that has gone on goes on as well
  if (!next_ && !last_.empty()) next_ = last_;
  is_waiting_ = has_checkpoints && !next_;
}

void StageState::take(const std::function<void()>& action) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_waiting_) return;
  if (const auto next = std::exchange(next_, std::nullopt)) {
    if (next->empty())
      part_->reset();
    else
      slam::restore(*next, *part_);
  }
  action();
}

bool StageState::isWaiting() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_waiting_;
}

void StageState::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (part_ == nullptr) return;
  if (has_checkpoints_) last_ = now();
  part_ = nullptr;
}

void StageState::goOnFrom(const std::string& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  next_ = state;
  is_waiting_ = false;
}

bool StageState::isHere() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return part_ != nullptr || !last_.empty();
}

std::string StageState::copy() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return now();
}

std::string StageState::now() const {
  if (next_) return next_->empty() ? fresh_ : *next_;
  return part_ != nullptr ? slam::stateOf(*part_) : last_;
}

}  // namespace slam_ros
