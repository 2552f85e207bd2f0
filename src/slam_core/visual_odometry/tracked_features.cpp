// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/tracked_features.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <optional>

namespace slam::visual_odometry {
namespace {

const cv::Size kPatch(21, 21);
constexpr int kLevels = 3;
constexpr double kMinQuality = 0.01, kMinDistance = 12.0;  // of corners, [px]
constexpr double kMinEigenvalue = 1e-3;                    // of a patch that can be tracked

cv::Point2f toPoint(const Eigen::Vector2d& pixel) {
  return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

/// The same mean and contrast for all images: patches are compared by their gray values.
cv::Mat evenlyLit(const cv::Mat& gray) {
  constexpr double kMean = 128.0, kContrast = 45.0, kMaxGain = 8.0;
  cv::Scalar mean, contrast;
  cv::meanStdDev(gray, mean, contrast);
  const double gain = std::min(kContrast / std::max(contrast[0], 1.0), kMaxGain);
  cv::Mat lit;
  gray.convertTo(lit, CV_8U, gain, kMean - gain * mean[0]);
  return lit;
}

cv::Point2f transform(const cv::Mat& A, const cv::Point2f& p) {
  const auto* a = A.ptr<double>();
  return {static_cast<float>(a[0] * p.x + a[1] * p.y + a[2]),
          static_cast<float>(a[3] * p.x + a[4] * p.y + a[5])};
}

/// Where the window expects a pixel of the reference, about the middle of the image (2x3).
std::optional<cv::Mat> expectedMotion(const cv::Size& size, const CeilingView& view,
                                      const Pose2& T_now_reference) {
  constexpr float kArm = 60.0F;  // [px]
  const cv::Point2f middle(0.5F * static_cast<float>(size.width),
                           0.5F * static_cast<float>(size.height));
  const cv::Point2f from[] = {middle, middle + cv::Point2f(kArm, 0), middle + cv::Point2f(0, kArm)};
  cv::Point2f to[3];
  for (int i = 0; i < 3; ++i) {
    const auto point = view.toCeiling({from[i].x, from[i].y});
    const auto pixel = point ? view.toPixel(T_now_reference.transform(*point)) : std::nullopt;
    if (!pixel) return std::nullopt;
    to[i] = toPoint(*pixel);
  }
  return cv::getAffineTransform(from, to);
}

/// A reference as it should look now: patches are compared as they are, not turned.
struct TurnedReference {
  TurnedReference(const Features& reference, const CeilingView& view,
                  const Pose2& T_now_reference) {
    constexpr double kWorthTurning = 0.03;  // [rad]
    std::optional<cv::Mat> A;
    const auto& image = reference.pyramid.front();
    if (std::abs(T_now_reference.theta()) > kWorthTurning)
      A = expectedMotion(image.size(), view, T_now_reference);
    for (const auto& pixel : reference.pixels)
      corners.push_back(A ? transform(*A, toPoint(pixel)) : toPoint(pixel));
    if (!A) {
      pyramid = reference.pyramid;
      return;
    }
    cv::Mat turned;
    cv::warpAffine(image, turned, *A, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::buildOpticalFlowPyramid(turned, pyramid, kPatch, kLevels);
  }

  std::vector<cv::Mat> pyramid;
  std::vector<cv::Point2f> corners;
};

}  // namespace

Features TrackedFeatures::extract(const cv::Mat& gray, const CeilingView& /*view*/) {
  Features features;
  cv::buildOpticalFlowPyramid(evenlyLit(gray), features.pyramid, kPatch, kLevels);
  return features;
}

void TrackedFeatures::prepareReference(Features& features, const CeilingView& view) const {
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(features.pyramid.front(), corners, max_features_ / 2, kMinQuality,
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
  const TurnedReference from(reference, view, T_now_reference);
  std::vector<cv::Point2f> to;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const auto expected = view.toPixel(T_now_reference.transform(reference.points[i]));
    to.push_back(toPoint(expected.value_or(reference.pixels[i])));
  }
  std::vector<uchar> found;
  std::vector<float> errors;
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01);
  cv::calcOpticalFlowPyrLK(from.pyramid, now.pyramid, from.corners, to, found, errors, kPatch,
                           kLevels, until, cv::OPTFLOW_USE_INITIAL_FLOW, kMinEigenvalue);
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
