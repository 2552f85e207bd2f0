// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_clock.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace slam::eval {
namespace {

std::string secondsText(std::int64_t stamp) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  char text[32];
  std::snprintf(text, sizeof text, "%lld.%09lld", static_cast<long long>(stamp / kSecond),
                static_cast<long long>(stamp % kSecond));
  return text;
}

}  // namespace

CarmenClock makeClock(const std::vector<CarmenLog::Scan>& scans) {
  CarmenClock clock;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::int64_t source = scans[i].stamp;
    if (i == 0) {
      clock.written.push_back(source);
      continue;
    }
    const std::int64_t before = scans[i - 1].stamp;
    if (source == before) ++clock.repeated;
    if (source < before) ++clock.steps_back;
    clock.largest_step_back = std::max(clock.largest_step_back, before - source);
    clock.written.push_back(std::max(source, clock.written.back() + CarmenClock::kStep));
  }
  return clock;
}

std::vector<std::size_t> odometryBetween(const CarmenLog& log, const CarmenClock& clock) {
  std::vector<std::size_t> kept;
  std::int64_t newest = 0;
  std::size_t scan = 0;
  for (std::size_t i = 0; i < log.odometry.size(); ++i) {
    while (scan < log.scans.size() && log.scans[scan].odometry_before <= i)
      newest = std::max(newest, clock.written[scan++]);
    const auto next =
        scan < log.scans.size() ? clock.written[scan] : std::numeric_limits<std::int64_t>::max();
    const auto stamp = log.odometry[i].stamp;
    if (stamp <= newest || stamp >= next) continue;
    kept.push_back(i);
    newest = stamp;
  }
  return kept;
}

std::string stampTable(const std::vector<CarmenLog::Scan>& scans, const CarmenClock& clock) {
  std::string table = "source_stamp,written_stamp\n";
  for (std::size_t i = 0; i < scans.size(); ++i)
    table += secondsText(scans[i].stamp) + "," + secondsText(clock.written[i]) + "\n";
  return table;
}

}  // namespace slam::eval
