// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam_ros {

/// Which kind of a camera's images is subscribed to.
enum class ImageTransport { kAuto, kRaw, kCompressed };

/// Private parameter of a nodelet that subscribes to a camera.
struct TransportConfig {
  static constexpr const char* kSection = "";

  ImageTransport transport = ImageTransport::kAuto;

  void describe(slam::Fields& fields) {
    fields.add("transport", &transport,
               {{"auto", ImageTransport::kAuto},
                {"raw", ImageTransport::kRaw},
                {"compressed", ImageTransport::kCompressed}},
               "of the images; auto: the kind that comes first stays");
  }
};

}  // namespace slam_ros
