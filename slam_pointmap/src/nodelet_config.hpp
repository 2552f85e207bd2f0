// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam_pointmap {

/// The nodelet's private parameters.
struct NodeletConfig {
  static constexpr const char* kSection = "";

  std::string output_dir;
  double points_rate = 1.0;

  void describe(slam::Fields& fields) {
    fields.add("output_dir", &output_dir, "folder that gets a points.pcd at the end");
    fields.add("points_rate", &points_rate, "of the points, at most")
        .unit("1/s of stamps")
        .in(slam::Range::above(0));
  }
};

}  // namespace slam_pointmap
