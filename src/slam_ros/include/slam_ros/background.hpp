// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <future>

namespace slam_ros {

/// Does one piece of work at a time in another thread than the caller's.
class Background {
 public:
  /// @return false if the last piece is not done yet; then this one is not accepted
  bool tryRun(std::function<void()> work);
  bool isBusy() const;
  /// Waits for the last piece.
  void wait() const;
  ~Background();

 private:
  std::future<void> work_;
};

}  // namespace slam_ros
