// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <string>

#include "slam_core/common/time.hpp"

namespace slam_ros {

/// Counts messages of several inputs that were sent and not yet acknowledged. A sender waits here,
/// so that no queue after it overflows. One thread sends, another one acknowledges. Acknowledging a
/// stamp acknowledges all earlier ones.
class FlowWindow {
 public:
  using Timeout = std::chrono::milliseconds;

  explicit FlowWindow(std::size_t capacity) : capacity_(capacity) {}

  /// Sets another capacity for one input, whose messages are large.
  void limit(const std::string& input, std::size_t capacity);

  void sent(const std::string& input, slam::Stamp stamp);
  void acknowledged(const std::string& input, slam::Stamp up_to);

  /// Waits until the input may send. @return false if nothing at all was acknowledged for
  /// `patience`, or after stop()
  bool waitForRoom(const std::string& input, Timeout patience);
  /// Waits until no message of an earlier stamp is in flight. @return as above
  bool waitForAllBefore(slam::Stamp stamp, Timeout patience);
  /// Waits until everything is acknowledged. @return as above
  bool waitUntilEmpty(Timeout patience);

  /// Gives up what is in flight.
  void clear();
  std::size_t inFlight() const;
  /// Ends all waiting, now and later.
  void stop();

 private:
  template <class Condition>
  bool waitFor(Condition condition, Timeout patience);
  std::size_t sum() const;
  std::size_t capacityOf(const std::string& input) const;

  std::size_t capacity_;
  std::map<std::string, std::size_t> limits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::deque<slam::Stamp>> sent_;
  std::uint64_t acknowledgements_ = 0;
  bool stopped_ = false;
};

}  // namespace slam_ros
