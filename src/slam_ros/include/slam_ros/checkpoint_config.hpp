// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam_ros {

/// Parameters in the namespace `checkpoints` of the product.
struct CheckpointConfig {
  static constexpr const char* kSection = "";

  std::string folder;
  double autosave = 10.0;
  bool resume = false;
  bool restarted = false;

  void describe(slam::Fields& fields) {
    fields.add("folder", &folder, "takes the checkpoints; none is written without");
    fields.add("autosave", &autosave, "interval of the checkpoints")
        .unit("s of stamps")
        .in(slam::Range::above(0));
    fields.add("resume", &resume, "go on from the folder's checkpoint, where there is one");
    fields.add("restarted", &restarted,
               "an earlier process of the same launch has died; the nodelet sets it");
  }
};

}  // namespace slam_ros
