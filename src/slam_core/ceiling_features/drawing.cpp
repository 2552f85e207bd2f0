// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/drawing.hpp"

#include <opencv2/imgproc.hpp>

#include "slam_core/camera/drawn_point.hpp"

namespace slam::ceiling_features {
namespace {

const cv::Scalar kGreen(0, 200, 0), kRed(80, 80, 255);

}  // namespace

cv::Mat draw(const cv::Mat& gray, const std::vector<CeilingFeature>& features) {
  cv::Mat picture;
  if (gray.empty() || gray.type() != CV_8UC1) return picture;
  cv::cvtColor(gray, picture, cv::COLOR_GRAY2BGR);
  for (const auto& feature : features) {
    const bool is_landmark = feature.rejection.empty();
    const int radius = (is_landmark ? 10 : 2) << kFractionBits;
    cv::circle(picture, drawnAt(feature.spot.pixel), radius, is_landmark ? kGreen : kRed,
               is_landmark ? 2 : cv::FILLED, cv::LINE_AA, kFractionBits);
  }
  return picture;
}

}  // namespace slam::ceiling_features
