// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::scan_matching {

/// How scans are matched with a map.
struct MatcherConfig {
  static constexpr const char* kSection = "scan_to_map";

  double spacing = 0.02;
  double sigma = 0.03;
  double correlation = 2.0;
  double doubt_share = 0.1;
  double window_position = 0.4;
  double window_heading = 0.4;
  double wide_position = 6.0;
  double wide_heading = 1.6;
  double false_alarm_hours = 1000.0;

  void describe(Fields& fields);
};

}  // namespace slam::scan_matching
