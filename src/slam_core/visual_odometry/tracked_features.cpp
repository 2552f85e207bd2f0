// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/tracked_features.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace slam::visual_odometry {
namespace {

const cv::Size kPatch(21, 21);
constexpr int kLevels = 3;
constexpr double kMinQuality = 0.01, kMinDistance = 12.0;  // of corners, [px]
constexpr double kMinEigenvalue = 1e-3;                    // of a patch that can be tracked

cv::Point2f toPoint(const Eigen::Vector2d& pixel) {
  return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

}  // namespace

Features TrackedFeatures::extract(const cv::Mat& gray, const CeilingView& /*view*/) {
  Features features;
  cv::buildOpticalFlowPyramid(gray, features.pyramid, kPatch, kLevels);
  return features;
}

void TrackedFeatures::prepareReference(Features& features, const CeilingView& view) const {
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(features.pyramid.front(), corners, max_features_, kMinQuality,
                          kMinDistance);
  features.pixels.clear();
  features.points.clear();
  for (const auto& corner : corners) {
    const Eigen::Vector2d pixel(corner.x, corner.y);
    const auto point = view.toCeiling(pixel);
    if (!point) continue;
    features.pixels.push_back(pixel);
    features.points.push_back(*point);
  }
  features.sigmas.assign(features.pixels.size(), 1.0);
}

PointMatches TrackedFeatures::match(const Features& reference, const Features& now,
                                    const CeilingView& view, const SearchWindow& window) const {
  PointMatches matches;
  if (reference.pixels.empty()) return matches;
  const Pose2 T_now_reference = window.T_reference_now.inverse();
  std::vector<cv::Point2f> from, to;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const auto expected = view.toPixel(T_now_reference.transform(reference.points[i]));
    from.push_back(toPoint(reference.pixels[i]));
    to.push_back(toPoint(expected.value_or(reference.pixels[i])));
  }
  std::vector<uchar> found;
  std::vector<float> errors;
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01);
  cv::calcOpticalFlowPyrLK(reference.pyramid, now.pyramid, from, to, found, errors, kPatch, kLevels,
                           until, cv::OPTFLOW_USE_INITIAL_FLOW, kMinEigenvalue);
  const cv::Size size = now.pyramid.front().size();
  const double sigma = std::sqrt(2.0) * view.metresPerPixel();
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Eigen::Vector2d pixel(to[i].x, to[i].y);
    const bool inside = pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= size.width - 1 &&
                        pixel.y() <= size.height - 1;
    if (found[i] == 0 || !inside) continue;
    const auto point = view.toCeiling(pixel);
    if (!point) continue;
    const Eigen::Vector2d off = window.T_reference_now.transform(*point) - reference.points[i];
    if (off.norm() > window.radius(*point)) continue;
    matches.push_back({reference.pixels[i], pixel, reference.points[i], *point, sigma});
  }
  return matches;
}

}  // namespace slam::visual_odometry
