// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "slam_core/camera/camera_gate.hpp"
#include "slam_core/contract/landmark_detector.hpp"
#include "slam_sim/camera_renderer.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {

/// What is true of a marker in an image.
struct MarkerTruth {
  double range, bearing;                   ///< in the camera's horizontal plane [m], [rad]
  std::array<Eigen::Vector2d, 4> corners;  ///< upper left, then clockwise [px]
};

/// A detector that looks at one rendered marker whose pose is known: for tests and benchmarks. The
/// camera is level and looks along the x axis of its base.
class MarkerStand {
 public:
  static constexpr const char* kFamily = "36h11";  ///< read by both kinds of detectors
  static constexpr std::int64_t kId = 42;
  static constexpr double kSize = 0.16;  ///< [m]

  /// @param detector configured; gets calibration, mount and images from here
  MarkerStand(std::unique_ptr<LandmarkDetector> detector, const CameraCalibration& calibration,
              const CameraOptics& optics);

  /// @pre the marker is before the camera
  MarkerTruth truth(const Eigen::Isometry3d& T_world_camera) const;
  /// What the detector makes of one image; nothing where it does not see the marker or rejects it.
  /// @param frame rises from image to image
  std::optional<LandmarkObservation> look(const CameraPath& T_world_camera, std::uint64_t frame);
  Counters counters() const { return detector_->counters(); }

 private:
  World world_;
  CameraRenderer camera_;
  CameraGate gate_;
  std::unique_ptr<LandmarkDetector> detector_;
  Ports ports_;  ///< its
};

/// The index-th of many poses of a camera at about that distance [m] and obliqueness [rad] from the
/// stand's marker: no two have its corners on the same parts of pixels.
/// @param aside largest angle of the marker to the optical axis [rad]
Eigen::Isometry3d poseBefore(double distance, double obliqueness, double aside,
                             std::uint64_t index);

}  // namespace slam::sim
