// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/camera_model.hpp"
#include "slam_core/camera/image.hpp"

namespace slam {

/// An image with what must be known of its camera to measure in it. The gate of the camera makes it
/// (CameraGate).
struct CameraView {
  Stamp stamp;
  Image image;
  CameraMount mount;
  std::shared_ptr<const CameraModel> camera;  ///< null where the image cannot be used
  bool is_repeated = false;                   ///< the image before it, to the bit

  /// Whether the image shows something new; otherwise most components only move time on.
  bool isUsable() const { return camera != nullptr && !is_repeated; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, image, mount, camera, is_repeated);
  }
};

}  // namespace slam
