// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam_ros {

/// Private parameter of a nodelet that subscribes a camera.
struct TransportConfig {
  static constexpr const char* kSection = "";

  std::string transport = "auto";

  void describe(slam::Fields& fields) {
    fields.add("transport", &transport, "of the images; auto: the kind that comes first stays")
        .oneOf({"auto", "raw", "compressed"});
  }
};

}  // namespace slam_ros
