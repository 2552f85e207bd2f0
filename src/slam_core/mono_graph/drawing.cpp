// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/drawing.hpp"

#include <opencv2/imgproc.hpp>

#include "slam_core/camera/drawn_point.hpp"

namespace slam::mono_graph {
namespace {

const cv::Scalar kOfMap(0, 200, 0), kOfNoFit(60, 60, 255), kOfNoPoint(150, 150, 150);

void drawFeature(const Feature& feature, int radius, const cv::Scalar& colour, cv::Mat& picture) {
  cv::circle(picture, drawnAt(feature.pixel), radius << kFractionBits, colour, cv::FILLED,
             cv::LINE_AA, kFractionBits);
}

}  // namespace

cv::Mat draw(const cv::Mat& gray, const Features& features, const TrackedView& tracked) {
  cv::Mat picture;
  if (gray.empty() || gray.type() != CV_8UC1) return picture;
  cv::cvtColor(gray, picture, cv::COLOR_GRAY2BGR);
  for (const auto& feature : features.all()) drawFeature(feature, 1, kOfNoPoint, picture);
  for (const auto& match : tracked.rejected)
    drawFeature(features[match.feature], 3, kOfNoFit, picture);
  for (const auto& match : tracked.matches)
    drawFeature(features[match.feature], 3, kOfMap, picture);
  return picture;
}

}  // namespace slam::mono_graph
