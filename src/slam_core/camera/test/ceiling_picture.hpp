// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"

// Pictures of a speckled ceiling for tests that need the truth.

namespace slam::test::ceilings {

constexpr double kCeilingHeight = 2.5;  ///< above the floor [m]

/// 320x240, 60 degrees wide, with the distortion of a cheap lens.
inline CameraCalibration smallCamera() {
  CameraCalibration camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 280.0;
  camera.cx = 158.7;
  camera.cy = 121.2;
  camera.distortion_model = "plumb_bob";
  camera.distortion = {0.08, -0.18, -0.0008, 0.0006, 0.0};
  return camera;
}

/// Looks up from 0.8 m above the floor, `x` before the robot's middle; turned about the vertical
/// and tilted from it.
inline CameraMount mountUp(double x = 0.0, double turn = 0.0, double tilt = 0.0) {
  CameraMount mount;
  mount.camera_frame = "ceiling_camera";
  mount.T_base_camera = Eigen::Translation3d(x, 0.0, 0.8) *
                        Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX());
  return mount;
}

/// A plane of dark and light spots of all sizes.
class Ceiling {
 public:
  explicit Ceiling(double height = kCeilingHeight, std::uint64_t seed = 1) : height_(height) {
    texture_ = cv::Mat(kEdge, kEdge, CV_32F, cv::Scalar(150.0));
    RandomStream random(seed, 0);
    const auto pick = [&](int n) { return static_cast<int>(random.uniform() * n); };
    for (int i = 0; i < 9000; ++i)
      cv::circle(texture_, {pick(kEdge), pick(kEdge)}, 3 + pick(12), 60.0 + pick(180), cv::FILLED);
    cv::GaussianBlur(texture_, texture_, {}, 1.5);
  }

  /// What smallCamera() sees, without noise (CV_32F).
  cv::Mat seenBy(const CameraMount& mount, const Pose2& T_world_base) const {
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    T_world_camera.translation().head<2>() = T_world_base.position();
    T_world_camera.linear().topLeftCorner<2, 2>() = T_world_base.rotation();
    T_world_camera = T_world_camera * mount.T_base_camera;
    const auto calibration = smallCamera();
    cv::Mat map(calibration.height, calibration.width, CV_32FC2);
    auto on_plane = rays().begin();
    for (int y = 0; y < map.rows; ++y)
      for (int x = 0; x < map.cols; ++x, ++on_plane) {
        const Eigen::Vector3d ray = T_world_camera.linear() * on_plane->homogeneous();
        const double way = (height_ - T_world_camera.translation().z()) / ray.z();
        const Eigen::Vector3d at = T_world_camera.translation() + way * ray;
        map.at<cv::Vec2f>(y, x) = {static_cast<float>(at.x() / kTexel + 0.5 * kEdge),
                                   static_cast<float>(at.y() / kTexel + 0.5 * kEdge)};
      }
    cv::Mat seen;
    cv::remap(texture_, seen, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, 20.0);
    return seen;
  }

 private:
  /// Of all pixels, row by row, on the plane z = 1.
  static const std::vector<Eigen::Vector2d>& rays() {
    static const auto kRays = [] {
      const CameraModel camera(smallCamera());
      std::vector<Eigen::Vector2d> all;
      for (int y = 0; y < camera.calibration().height; ++y)
        for (int x = 0; x < camera.calibration().width; ++x)
          all.push_back(camera.unproject({x, y}).value_or(Eigen::Vector2d(0.0, 0.0)));
      return all;
    }();
    return kRays;
  }

  static constexpr int kEdge = 2400;       // [texels]
  static constexpr double kTexel = 0.003;  // [m]

  double height_;
  cv::Mat texture_;
};

/// As the camera delivers it: brightness, blur [px], noise [of 255].
struct Exposure {
  double brightness = 1.0, blur = 0.0, noise = 2.0;
};

/// Standard normal numbers of twice the size of a picture each way, drawn once.
inline const cv::Mat& noiseField() {
  static const cv::Mat kField = [] {
    cv::Mat field(480, 640, CV_32F);
    RandomStream random(7, 0);
    for (auto value = field.begin<float>(); value != field.end<float>(); ++value)
      *value = static_cast<float>(random.gaussian());
    return field;
  }();
  return kField;
}

/// The number tells pictures of the same light apart: each gets another part of the noise.
inline cv::Mat exposed(const cv::Mat& light, const Exposure& exposure, std::uint64_t number) {
  cv::Mat image = light;
  if (exposure.blur > 0.0) cv::GaussianBlur(light, image, {}, exposure.blur);
  RandomStream random(8, number);
  const cv::Size room = noiseField().size() - light.size();
  const cv::Point corner(static_cast<int>(random.uniform() * room.width),
                         static_cast<int>(random.uniform() * room.height));
  cv::Mat gray;
  cv::addWeighted(image, exposure.brightness, noiseField()(cv::Rect(corner, light.size())),
                  exposure.noise, 0.0, gray, CV_8U);
  return gray;
}

}  // namespace slam::test::ceilings
