// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/corner_finder.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace slam::mono_ekf {
namespace {

struct Corner {
  cv::Point pixel;
  float strength;
};

/// The strongest pixel of each square of an image; those that have none are left out.
std::vector<Corner> strongestOfSquares(const cv::Mat& strengths, float least, int edge,
                                       int border) {
  std::vector<Corner> corners;
  for (int top = border; top < strengths.rows - border; top += edge)
    for (int left = border; left < strengths.cols - border; left += edge) {
      const cv::Rect square(left, top, std::min(edge, strengths.cols - border - left),
                            std::min(edge, strengths.rows - border - top));
      double strength = 0.0;
      cv::Point pixel;
      cv::minMaxLoc(strengths(square), nullptr, &strength, nullptr, &pixel);
      if (strength >= least) corners.push_back({pixel + square.tl(), static_cast<float>(strength)});
    }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.strength > b.strength; });
  return corners;
}

bool isFree(const Eigen::Vector2d& pixel, const std::vector<Eigen::Vector2d>& occupied,
            double spacing) {
  return std::none_of(occupied.begin(), occupied.end(), [&](const Eigen::Vector2d& other) {
    return (pixel - other).squaredNorm() < spacing * spacing;
  });
}

}  // namespace

std::vector<Eigen::Vector2d> cornersOf(const cv::Mat& gray,
                                       const std::vector<Eigen::Vector2d>& occupied,
                                       double least_gradient, int spacing, int border) {
  constexpr int kBlock = 5, kSobel = 3;
  cv::Mat smooth, strengths;
  cv::GaussianBlur(gray, smooth, {5, 5}, 1.0);
  cv::cornerMinEigenVal(smooth, strengths, kBlock, kSobel);
  const double gradient = least_gradient / 255.0;  // in OpenCV's unit
  const auto corners =
      strongestOfSquares(strengths, static_cast<float>(gradient * gradient), spacing, border);
  std::vector<Eigen::Vector2d> taken = occupied, found;
  for (const auto& corner : corners) {
    const Eigen::Vector2d pixel(corner.pixel.x, corner.pixel.y);
    if (!isFree(pixel, taken, spacing)) continue;
    taken.push_back(pixel);
    found.push_back(pixel);
  }
  return found;
}

}  // namespace slam::mono_ekf
