// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/time.hpp"

namespace slam {

/// The usual interval between the messages of a source, of which a silence stands out. A silence
/// hardly changes it, but a source that is slower from now on is usual after some messages.
class UsualInterval {
 public:
  void note(Duration interval) {
    constexpr int kMessagesMeant = 20;
    usual_ += usual_ > Duration() ? (interval - usual_) / kMessagesMeant : interval;
  }
  /// Whether messages are missing in an interval of this length.
  /// @param patience shorter intervals are never too long
  bool isExceededBy(Duration interval, Duration patience) const {
    return usual_ > Duration() && interval > patience && interval > 3 * usual_;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(usual_);
  }

 private:
  Duration usual_{};  ///< 0: none yet
};

}  // namespace slam
