// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <string>

#include "slam_sim/camera_renderer.hpp"

// One marker on a wall and a camera in front of it: for tests and benchmarks that need the truth.

namespace slam::sim {

/// VGA, 63 degrees wide, with a distortion of 10 px in the corners.
inline CameraCalibration studioCalibration() {
  CameraCalibration camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 520.0;
  camera.fy = 523.0;
  camera.cx = 322.3;
  camera.cy = 236.8;
  camera.distortion_model = "plumb_bob";
  camera.distortion = {-0.28, 0.09, 0.0006, -0.0004, 0.0};
  return camera;
}

/// The same camera, of which only `width` x `height` pixels about the principal point are read.
inline CameraCalibration studioWindow(int width, int height) {
  CameraCalibration camera = studioCalibration();
  camera.cx -= (camera.width - width) / 2;
  camera.cy -= (camera.height - height) / 2;
  camera.width = width;
  camera.height = height;
  return camera;
}

/// A marker in the world's middle, 1 m above the floor, that looks along +x.
inline World studioWorld(const std::string& family, std::int64_t id, double size = 0.16) {
  World world;
  world.walls = {{{-0.005, -4.0}, {-0.005, 4.0}, 2.5, 0.7}};
  world.markers = {{family, id, size, uprightMarker({0.0, 0.0, 1.0}, 0.0)}};
  return world;
}

/// The optical frame of a camera `distance` before the marker, its normal turned away from the
/// camera by `obliqueness`; the axis of the camera passes the marker at `aside` [rad] of the
/// camera's x and y.
inline Eigen::Isometry3d cameraBefore(double distance, double obliqueness,
                                      const Eigen::Vector2d& aside = {0.0, 0.0}) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  Eigen::Matrix3d facing;  // the camera looks along -x
  facing.col(0) = Vector3d::UnitY();
  facing.col(1) = -Vector3d::UnitZ();
  facing.col(2) = -Vector3d::UnitX();
  const Eigen::Matrix3d R = AngleAxisd(obliqueness, Vector3d::UnitZ()) * facing;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Vector3d(0.0, 0.0, 1.0) - distance * R.col(2);
  T.linear() =
      R * AngleAxisd(-aside.x(), Vector3d::UnitY()) * AngleAxisd(aside.y(), Vector3d::UnitX());
  return T;
}

inline CameraPath standing(const Eigen::Isometry3d& T) {
  return [T](double) { return T; };
}

inline CameraRenderer studioCamera(const World& world, const CameraOptics& optics = {}) {
  return {std::make_shared<const Scene>(world), studioCalibration(), optics};
}

/// Corners of the square a detector returns, in the optical frame: upper left, upper right, lower
/// right, lower left.
inline std::array<Eigen::Vector3d, 4> cornersOf(const Marker& marker,
                                                const Eigen::Isometry3d& T_world_camera) {
  const double half = marker.size / 2.0;
  std::array<Eigen::Vector3d, 4> corners{
      Eigen::Vector3d(-half, half, 0.0), Eigen::Vector3d(half, half, 0.0),
      Eigen::Vector3d(half, -half, 0.0), Eigen::Vector3d(-half, -half, 0.0)};
  for (auto& corner : corners) corner = T_world_camera.inverse() * marker.T_world_marker * corner;
  return corners;
}

}  // namespace slam::sim
