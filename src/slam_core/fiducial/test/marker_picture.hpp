// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/aruco.hpp>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/fiducial/square_pose.hpp"

namespace slam::fiducial::test {

/// A marker as it is printed: one gray level a cell, a quiet zone around the square whose corners
/// are the marker's.
struct PrintedMarker {
  cv::Mat cells;
  int quiet_cells = 1;  ///< of `cells` on each side that lie outside the square
  double size = 0.16;   ///< edge of the square [m]
};

inline PrintedMarker printedMarker(int id, double size = 0.16,
                                   int dictionary = cv::aruco::DICT_APRILTAG_36h11) {
  const auto codes = cv::aruco::getPredefinedDictionary(dictionary);
  const int cells = codes->markerSize + 2;
  PrintedMarker marker;
  marker.size = size;
  marker.cells = cv::Mat(cells + 2, cells + 2, CV_8UC1, cv::Scalar(255));
  cv::Mat inside;
  codes->drawMarker(id, cells, inside, 1);
  // OpenCV has the AprilTags the other way up than their authors
  if (dictionary >= cv::aruco::DICT_APRILTAG_16h5) cv::flip(inside, inside, -1);
  inside.copyTo(marker.cells(cv::Rect(1, 1, cells, cells)));
  return marker;
}

/// Pictures of markers through a lens: every pixel is the mean of 64 rays.
class MarkerPicture {
 public:
  explicit MarkerPicture(const CameraModel& camera, double background = 150.0)
      : camera_(camera),
        pixels_(camera.calibration().height, camera.calibration().width, CV_32F,
                cv::Scalar(background)) {}

  void add(const PrintedMarker& marker, const Eigen::Isometry3d& T_camera_marker) {
    const auto box = boxOf(marker, T_camera_marker);
    const Eigen::Isometry3d T_marker_camera = T_camera_marker.inverse();
    for (int v = box.y; v < box.y + box.height; ++v)
      for (int u = box.x; u < box.x + box.width; ++u)
        pixels_.at<float>(v, u) = meanOf(marker, T_marker_camera, u, v);
  }

  /// What a sensor makes of it: black and white of a print, Gaussian noise.
  cv::Mat exposed(double noise = 0.0, std::uint64_t seed = 1) const {
    RandomStream random(seed, 0);
    cv::Mat image(pixels_.size(), CV_8UC1);
    for (int v = 0; v < pixels_.rows; ++v)
      for (int u = 0; u < pixels_.cols; ++u)
        image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
            30.0 + 0.75 * static_cast<double>(pixels_.at<float>(v, u)) +
            (noise > 0.0 ? noise * random.gaussian() : 0.0));
    return image;
  }

 private:
  static double edgeOf(const PrintedMarker& marker) {
    return marker.size * marker.cells.cols / (marker.cells.cols - 2 * marker.quiet_cells);
  }

  cv::Rect boxOf(const PrintedMarker& marker, const Eigen::Isometry3d& T_camera_marker) const {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const auto& corner : cornersOfSquare(edgeOf(marker))) {
      const auto pixel = camera_.project(T_camera_marker * corner);
      if (!pixel) return {0, 0, pixels_.cols, pixels_.rows};
      left = std::min(left, pixel->x()), right = std::max(right, pixel->x());
      top = std::min(top, pixel->y()), bottom = std::max(bottom, pixel->y());
    }
    constexpr double kSlack = 6.0;  // a distorted edge bulges beyond its ends
    const cv::Rect box(
        cv::Point(static_cast<int>(left - kSlack), static_cast<int>(top - kSlack)),
        cv::Point(static_cast<int>(right + kSlack), static_cast<int>(bottom + kSlack)));
    return box & cv::Rect(0, 0, pixels_.cols, pixels_.rows);
  }

  /// Within a pixel the lens is taken as linear.
  float meanOf(const PrintedMarker& marker, const Eigen::Isometry3d& T_marker_camera, int u,
               int v) const {
    constexpr int kRays = 8;
    const float behind = pixels_.at<float>(v, u);
    const auto centre = camera_.unproject(Eigen::Vector2d(u, v));
    const auto right = camera_.unproject(Eigen::Vector2d(u + 1, v));
    const auto below = camera_.unproject(Eigen::Vector2d(u, v + 1));
    if (!centre || !right || !below) return behind;
    double sum = 0.0;
    for (int i = 0; i < kRays * kRays; ++i) {
      const double du = (i % kRays + 0.5) / kRays - 0.5, dv = (i / kRays + 0.5) / kRays - 0.5;
      const Eigen::Vector2d on_plane = *centre + du * (*right - *centre) + dv * (*below - *centre);
      sum += brightness(marker, T_marker_camera, on_plane, behind);
    }
    return static_cast<float>(sum / (kRays * kRays));
  }

  static double brightness(const PrintedMarker& marker, const Eigen::Isometry3d& T_marker_camera,
                           const Eigen::Vector2d& on_plane, float behind) {
    const Eigen::Vector3d ray = T_marker_camera.linear() * on_plane.homogeneous();
    const Eigen::Vector3d eye = T_marker_camera.translation();
    const double way = -eye.z() / ray.z();
    if (!(way > 0.0)) return behind;
    const Eigen::Vector3d hit = eye + way * ray;
    const double cell = marker.size / (marker.cells.cols - 2 * marker.quiet_cells);
    const int column = static_cast<int>(std::floor((hit.x() + 0.5 * edgeOf(marker)) / cell));
    const int row = static_cast<int>(std::floor((0.5 * edgeOf(marker) - hit.y()) / cell));
    const bool is_inside =
        column >= 0 && row >= 0 && column < marker.cells.cols && row < marker.cells.rows;
    return is_inside ? marker.cells.at<std::uint8_t>(row, column) : behind;
  }

  CameraModel camera_;
  cv::Mat pixels_;
};

/// A marker that faces the camera at a place in the optical frame [m], turned by `obliqueness`
/// about the axis at `axis_angle` in its own plane [rad].
inline Eigen::Isometry3d facing(const Eigen::Vector3d& place, double obliqueness = 0.0,
                                double axis_angle = 0.0) {
  Eigen::Matrix3d front;
  front << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const Eigen::Vector3d axis(std::cos(axis_angle), std::sin(axis_angle), 0.0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), place).toRotationMatrix() *
      Eigen::AngleAxisd(obliqueness, axis).toRotationMatrix() * front;
  pose.translation() = place;
  return pose;
}

/// A camera as cheap robots have it: VGA, 62 degrees wide, with visible distortion.
inline CameraCalibration vgaCalibration() {
  return {640, 480, "plumb_bob", 525.0, 527.0, 318.3, 241.7, {-0.2, 0.05, 0.0005, -0.0003, 0.0}};
}

}  // namespace slam::fiducial::test
