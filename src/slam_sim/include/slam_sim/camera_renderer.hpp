// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/common/random.hpp"
#include "slam_sim/camera_optics.hpp"
#include "slam_sim/camera_rays.hpp"
#include "slam_sim/scene.hpp"

namespace slam::sim {

struct ViewedSurface;

/// The optical frame's pose in the world at a part of the image's time: 0 where the first row
/// begins to be exposed, 1 where the last row ends. Of a global shutter that is the exposure.
using CameraPath = std::function<Eigen::Isometry3d(double part)>;

/// A camera that takes pictures of a scene: pinhole with lens distortion, motion blur,
/// anti-aliasing and noise. Every sample of a pixel is a ray of its own at a time of its own
/// (distributed ray tracing; Cook, Porter and Carpenter, SIGGRAPH 1984); what it meets first is
/// found by projecting the scene's rectangles, tile by tile, with a depth test for each ray.
class CameraRenderer {
 public:
  /// @throw std::invalid_argument the calibration or the optics cannot be
  CameraRenderer(std::shared_ptr<const Scene> scene, const CameraCalibration& calibration,
                 const CameraOptics& optics);

  const CameraCalibration& calibration() const { return calibration_; }
  const CameraOptics& optics() const { return optics_; }

  /// An image of 8 bit, one channel, a function of its arguments only; from any thread.
  /// @param light_level of the whole world, 1 full light
  cv::Mat render(const CameraPath& T_world_camera, RandomStream noise,
                 double light_level = 1.0) const;

 private:
  /// When in the image's time a part of the exposure of a row of tiles is [0, 1].
  double partOf(double of_exposure, int tile_row) const;
  void renderBand(int first_row, int end_row, const std::vector<ViewedSurface>& viewed,
                  cv::Mat& light) const;
  void writeTile(int tile, const TileValues& values, cv::Mat& light) const;

  std::shared_ptr<const Scene> scene_;
  CameraCalibration calibration_;
  CameraOptics optics_;
  CameraRays rays_;
  cv::Mat gain_;  ///< from light to gray values, CV_32F
};

}  // namespace slam::sim
