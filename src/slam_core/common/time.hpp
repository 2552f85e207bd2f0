// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>

namespace slam {

/// The clock that stamps the data. It is never read: time comes with the messages.
struct DataClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<DataClock>;
  static constexpr bool is_steady = false;
};

using Duration = DataClock::duration;
using Stamp = DataClock::time_point;

constexpr Stamp stampFromNanoseconds(std::int64_t ns) { return Stamp(Duration(ns)); }
constexpr std::int64_t nanoseconds(Stamp stamp) { return stamp.time_since_epoch().count(); }

/// For models and reports only [s]; stamps are compared and added as integers.
constexpr double seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}
constexpr Duration durationFromSeconds(double s) {
  return Duration(static_cast<Duration::rep>(s * 1e9 + (s < 0 ? -0.5 : 0.5)));
}

/// Within a source, stamps that go back by more than this may begin a new run, and one that is
/// ahead by more than this is believed when the next one is ahead as well.
constexpr Duration kStampJump = std::chrono::seconds(5);

/// Whether a stamp follows another one without a jump.
inline bool isNext(Stamp before, Stamp stamp) {
  return stamp > before && stamp <= before + kStampJump;
}

}  // namespace slam
