// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "carmen_log.hpp"

namespace slam::eval {

/// Strictly rising stamps for a log whose own step back or stand twice: the larger of the source's
/// and the previous one + kStep.
struct CarmenClock {
  static constexpr std::int64_t kStep = 100'000;  // [ns]

  std::vector<std::int64_t> written;   // of each scan [ns]
  std::size_t steps_back = 0;          // source stamps before the one before them
  std::int64_t largest_step_back = 0;  // [ns]
  std::size_t repeated = 0;            // source stamps equal to the one before them
};

CarmenClock makeClock(const std::vector<CarmenLog::Scan>& scans);

/// Indices of the odometry lines that lie, by order and by stamp, strictly between the scans around
/// them; the scans bring the odometry of their own time.
std::vector<std::size_t> odometryBetween(const CarmenLog& log, const CarmenClock& clock);

/// The table of source and written stamps [s], a line for each scan.
std::string stampTable(const std::vector<CarmenLog::Scan>& scans, const CarmenClock& clock);

}  // namespace slam::eval
