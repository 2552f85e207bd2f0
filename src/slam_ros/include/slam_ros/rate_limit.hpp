// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam_ros {

/// Lets through at most `rate` events per second of the stamps' time.
class RateLimit {
 public:
  explicit RateLimit(double rate) { set(rate); }

  void set(double rate) { interval_ = slam::durationFromSeconds(1.0 / rate); }

  bool isDue(slam::Stamp stamp) {
    if (last_ && stamp >= *last_ && stamp - *last_ < interval_) return false;
    last_ = stamp;
    return true;
  }

 private:
  slam::Duration interval_;
  std::optional<slam::Stamp> last_;
};

}  // namespace slam_ros
