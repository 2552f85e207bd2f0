// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include "slam_core/common/time.hpp"

namespace slam {

/// The usual interval between the messages of a source, of which a silence stands out. A silence
/// doubles it at most, and a source that is slower from now on is usual after some messages.
class UsualInterval {
 public:
  void note(Duration interval) {
    constexpr int kMessagesMeant = 20;
    if (usual_ == Duration()) usual_ = interval;
    usual_ += (std::min(interval, kMessagesMeant * usual_) - usual_) / kMessagesMeant;
  }
  /// Whether messages are missing in an interval of this length.
  /// @param patience shorter intervals are never too long
  bool isExceededBy(Duration interval, Duration patience) const {
    return usual_ > Duration() && interval > patience && interval > 3 * usual_;
  }
  /// Whether a message that comes after this interval is one of a burst: a driver that was held up
  /// sends at once what it should have sent meanwhile.
  bool isOfBurst(Duration interval) const {
    constexpr int kTimesSooner = 4;
    return usual_ > Duration() && kTimesSooner * interval <= usual_;
  }
  /// @return zero if there was none yet
  Duration value() const { return usual_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(usual_);
  }

 private:
  Duration usual_{};  ///< 0: none yet
};

}  // namespace slam
