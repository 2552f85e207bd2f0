// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_ros {

/// The private parameters of an odometry source's nodelet.
struct OdometryNodeletConfig {
  static constexpr const char* kSection = "";

  TransportConfig camera;  ///< for a source with a camera
  bool publish_tf = true;
  bool publish_motion = true;

  void describe(slam::Fields& fields) {
    camera.describe(fields);
    fields.add("publish_tf", &publish_tf, "the transform odom -> base, unless another node does");
    fields.add("publish_motion", &publish_motion,
               "for the back-end; not where it is moved by another source, to compare with");
  }
};

}  // namespace slam_ros
