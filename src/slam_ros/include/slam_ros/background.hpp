// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <future>

namespace slam_ros {

/// One piece of work at a time beside the thread that hands it over.
class Background {
 public:
  /// @return false when the last piece is not done yet: this one is not taken
  bool tryRun(std::function<void()> work);
  bool isBusy() const;
  /// Waits for the last piece.
  void wait() const;
  ~Background();

 private:
  std::future<void> work_;
};

}  // namespace slam_ros
