// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/drawing.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "slam_core/camera/drawn_point.hpp"

namespace slam::fiducial {
namespace {

const cv::Scalar kGreen(0, 230, 0), kRed(80, 80, 255), kBlack(0, 0, 0);

std::vector<cv::Point> outline(const Corners& corners) {
  std::vector<cv::Point> points;
  for (const auto& corner : corners) points.push_back(drawnAt(corner));
  return points;
}

/// Where the text begins so that all of it is within the image.
cv::Point textOrigin(const Corners& corners, const cv::Size& text, const cv::Size& image) {
  double left = corners[0].x(), top = corners[0].y();
  for (const auto& corner : corners) {
    left = std::min(left, corner.x());
    top = std::min(top, corner.y());
  }
  const int x = std::min(static_cast<int>(left), image.width - text.width);
  return {std::max(x, 0), std::max(static_cast<int>(top) - 3, text.height)};
}

}  // namespace

cv::Mat draw(const cv::Mat& gray, const std::vector<MarkerDetection>& detections) {
  cv::Mat picture;
  if (gray.empty() || gray.type() != CV_8UC1) return picture;
  cv::cvtColor(gray, picture, cv::COLOR_GRAY2BGR);
  constexpr auto kFont = cv::FONT_HERSHEY_SIMPLEX;
  constexpr double kScale = 0.55;
  for (const auto& detection : detections) {
    const auto colour = detection.isAccepted() ? kGreen : kRed;
    cv::polylines(picture, outline(detection.corners), true, colour, 2, cv::LINE_AA, kFractionBits);
    auto text = std::to_string(detection.id);
    if (!detection.isAccepted()) text += " " + detection.rejection;
    const auto size = cv::getTextSize(text, kFont, kScale, 1, nullptr);
    const auto origin = textOrigin(detection.corners, size, picture.size());
    cv::putText(picture, text, origin, kFont, kScale, kBlack, 4, cv::LINE_AA);
    cv::putText(picture, text, origin, kFont, kScale, colour, 1, cv::LINE_AA);
  }
  return picture;
}

}  // namespace slam::fiducial
