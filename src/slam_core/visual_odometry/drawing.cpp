// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/drawing.hpp"

#include <opencv2/imgproc.hpp>

#include "slam_core/camera/drawn_point.hpp"

namespace slam::visual_odometry {
namespace {

const cv::Scalar kGreen(0, 200, 0), kRed(0, 0, 230);

void drawAll(cv::Mat& picture, const PointMatches& matches, const cv::Scalar& colour) {
  constexpr int kRadius = 2 << kFractionBits;
  for (const auto& match : matches) {
    const auto now = drawnAt(match.pixel_now);
    cv::line(picture, drawnAt(match.pixel_reference), now, colour, 1, cv::LINE_AA, kFractionBits);
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
