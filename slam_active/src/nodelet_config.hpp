// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/active_path/active_path_config.hpp"
#include "slam_core/common/config_fields.hpp"

namespace slam_active {

/// The nodelet's private parameters.
struct NodeletConfig {
  static constexpr const char* kSection = "";

  slam::active_path::ActivePathConfig explorer;
  double decision_rate = 1.0;

  void describe(slam::Fields& fields) {
    explorer.describe(fields);
    fields.add("decision_rate", &decision_rate, "of decisions, at most")
        .unit("1/s of stamps")
        .in(slam::Range::above(0));
  }
};

}  // namespace slam_active
