// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "slam_core/common/time.hpp"

namespace slam {

/// Holds a sensor's readings in their order until its mount is known: an identity mount is never
/// assumed. A mount applies only to readings of its frame, except for the configured mount, which
/// applies to every frame.
///
/// @tparam Reading has a `frame` and a `stamp`
/// @tparam Mount has a `frame`; faultOf(mount) is empty or says what makes it unusable
template <class Reading, class Mount>
class MountQueue {
 public:
  /// @param capacity at most so many readings wait for a mount
  explicit MountQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Starts afresh. A configured mount stays in force whatever else is set.
  void restart(const std::optional<Mount>& configured) {
    clear();
    is_mount_configured_ = false;
    mount_.reset();
    mount_fault_.clear();
    if (configured) set(*configured);
    is_mount_configured_ = configured.has_value();
  }

  /// The mount applies to all readings of its frame that are still held.
  void set(const Mount& mount) {
    if (is_mount_configured_) return;
    mount_ = mount;
    mount_fault_ = faultOf(mount);
  }

  void push(Reading reading) { held_.push_back(std::move(reading)); }

  /// Takes out the oldest reading, unless it waits for its mount. It waits while there is room and
  /// no reading behind it could be used.
  std::optional<Reading> pop() {
    if (held_.empty() || frontMayWait()) return std::nullopt;
    std::optional<Reading> reading = std::move(held_.front());
    held_.pop_front();
    return reading;
  }

  bool hasMount(const Reading& reading) const {
    return mount_ && (is_mount_configured_ || mount_->frame == reading.frame);
  }

  /// @pre hasMount() of some reading
  const Mount& mount() const { return *mount_; }
  const std::string& mountFault() const { return mount_fault_; }

  /// The frame whose mount the readings have been waiting for so long that a warning is due. The
  /// first readings always come before the transform.
  std::optional<std::string> missingFrame() const {
    if (held_.empty() || held_.back().stamp - held_.front().stamp <= kPatience) return std::nullopt;
    return held_.front().frame;
  }

  std::size_t size() const { return held_.size(); }

  /// Drops the readings and keeps the mount.
  void clear() { held_.clear(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(mount_, mount_fault_, held_);
  }

 private:
  static constexpr Duration kPatience = std::chrono::seconds(1);

  bool frontMayWait() const {
    return held_.size() <= capacity_ &&
           std::none_of(held_.begin(), held_.end(), [&](const auto& r) { return hasMount(r); });
  }

  std::size_t capacity_;
  bool is_mount_configured_ = false;
  std::optional<Mount> mount_;
  std::string mount_fault_;
  std::deque<Reading> held_;
};

}  // namespace slam
