// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/drawing.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace slam::visual_odometry {
namespace {

const cv::Scalar kGreen(0, 200, 0), kRed(0, 0, 230);
constexpr int kFractionBits = 4;  // ends are drawn to a 16th of a pixel

cv::Point toPoint(const Eigen::Vector2d& pixel) {
  return {static_cast<int>(std::lround(pixel.x() * (1 << kFractionBits))),
          static_cast<int>(std::lround(pixel.y() * (1 << kFractionBits)))};
}

void drawAll(cv::Mat& picture, const PointMatches& matches, const cv::Scalar& colour) {
  constexpr int kRadius = 2 << kFractionBits;
  for (const auto& match : matches) {
    const auto now = toPoint(match.pixel_now);
    cv::line(picture, toPoint(match.pixel_reference), now, colour, 1, cv::LINE_AA, kFractionBits);
    cv::circle(picture, now, kRadius, colour, cv::FILLED, cv::LINE_AA, kFractionBits);
  }
}

}  // namespace

cv::Mat draw(const cv::Mat& gray, const PointMatches& matches, const PointMatches& inliers) {
  cv::Mat picture;
  if (gray.empty() || gray.type() != CV_8UC1) return picture;
  cv::cvtColor(gray, picture, cv::COLOR_GRAY2BGR);
  drawAll(picture, matches, kRed);
  drawAll(picture, inliers, kGreen);
  return picture;
}

}  // namespace slam::visual_odometry
