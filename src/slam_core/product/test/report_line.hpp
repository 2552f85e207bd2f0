// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <string>

#include "slam_core/product/step_report.hpp"

namespace slam::test {

/// All that is reported of a step, to the last bit.
inline std::string lineOf(const StepReport& report) {
  auto line = fmt::format("{} {} {:a} {:a} {:a}", nanoseconds(report.stamp), report.trigger,
                          report.pose.pose.x(), report.pose.pose.y(), report.pose.pose.theta());
  for (const double each : report.pose.covariance.reshaped()) line += fmt::format(" {:a}", each);
  line += fmt::format(" {:a} {} {}", report.statistics.nis, report.statistics.used,
                      nameOf(report.trust, namesOfTrust()));
  for (const auto& event : report.events) line += " " + event.reason;
  return line + "\n";
}

}  // namespace slam::test
