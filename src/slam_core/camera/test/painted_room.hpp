// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/imgproc.hpp>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::test {

/// A wall is painted with so many grey rectangles, whose edges have lengths in a range.
struct Painting {
  int rectangles;
  double least_edge, most_edge;  ///< [m]
};

/// A square room with paintings on its walls, as a level camera without distortion sees it. Floor
/// and ceiling are bare.
class PaintedRoom {
 public:
  enum class Walls { kDifferent, kAlike };  ///< all four alike: a quarter turn changes nothing

  /// @param half of a wall's length [m]
  /// @param height of the walls [m]
  PaintedRoom(std::uint64_t seed, double half, double height, const Painting& painting,
              Walls walls = Walls::kDifferent)
      : half_(half),
        height_(height),
        texels_(0.5 * kLength / half),
        walls_(static_cast<int>(height * texels_), 4 * kLength, CV_8U) {
    for (int i = 0; i < 4; ++i)
      if (i == 0 || walls == Walls::kDifferent)
        paint(wall(i), painting, RandomStream(seed, static_cast<std::uint64_t>(i)));
      else if (i == 3)
        wall(0).copyTo(wall(i));
      else
        cv::flip(wall(0), wall(i), 1);  // their columns go from right to left
  }

  /// @param T_room_camera where the camera stands, looking along its x axis
  /// @param z of the camera above the floor [m]
  cv::Mat seenFrom(const Pose2& T_room_camera, double z, const CameraCalibration& camera) const {
    // Each column of a level camera's image shows one vertical line of a wall.
    cv::Mat x(camera.height, camera.width, CV_32F), y(camera.height, camera.width, CV_32F);
    for (int u = 0; u < camera.width; ++u) {
      const Line line = lineAlong(T_room_camera, (camera.cx - u) / camera.fx);
      x.col(u).setTo(line.column);
      for (int v = 0; v < camera.height; ++v) {
        const double height = z + line.depth * (camera.cy - v) / camera.fy;
        y.at<float>(v, u) = static_cast<float>((height_ - height) * texels_);
      }
    }
    cv::Mat image;
    cv::remap(walls_, image, x, y, cv::INTER_LINEAR, cv::BORDER_CONSTANT, kBare);
    return image;
  }

 private:
  static constexpr int kLength = 600;  // of a wall in walls_ [texels]
  static constexpr int kBare = 90;     // grey of floor and ceiling

  struct Line {
    float column;  // of walls_
    double depth;  // along the camera's axis [m]
  };

  cv::Mat wall(int which) { return walls_.colRange(which * kLength, (which + 1) * kLength); }

  void paint(cv::Mat wall, const Painting& painting, RandomStream random) const {
    wall.setTo(130);
    const double range = painting.most_edge - painting.least_edge;
    for (int i = 0; i < painting.rectangles; ++i) {
      const cv::Point at(static_cast<int>(wall.cols * random.uniform()),
                         static_cast<int>(wall.rows * random.uniform()));
      const double edge = painting.least_edge + range * random.uniform() * random.uniform();
      const int texels = static_cast<int>(edge * texels_);
      cv::rectangle(wall, at, at + cv::Point(texels, 2 + texels / 2),
                    cv::Scalar(255.0 * random.uniform()), cv::FILLED);
    }
  }

  /// @param left of the camera's axis at a distance of 1 along it
  Line lineAlong(const Pose2& T_room_camera, double left) const {
    const Eigen::Vector2d ray = T_room_camera.rotation() * Eigen::Vector2d(1.0, left);
    const Eigen::Vector2d from = T_room_camera.position();
    const Eigen::Vector2d reach =
        ((ray.array() > 0.0).select(half_, Eigen::Array2d(-half_, -half_)) - from.array()) /
        ray.array();
    const int axis = reach.x() < reach.y() ? 0 : 1, across = 1 - axis;
    const int wall = 2 * axis + (ray[axis] > 0.0 ? 0 : 1);
    const double along = from[across] + reach[axis] * ray[across] + half_;
    return {static_cast<float>(wall * kLength + along * texels_), reach[axis]};
  }

  double half_, height_;
  double texels_;  // a metre
  cv::Mat walls_;  // side by side
};

}  // namespace slam::test
