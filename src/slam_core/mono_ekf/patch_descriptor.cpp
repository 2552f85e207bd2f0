// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/patch_descriptor.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace slam::mono_ekf {
namespace {

constexpr int kSamplesOfAnEdge = 8;
constexpr double kSpacing = 4.0;        // between samples [px]
constexpr double kSmoothing = 2.0;      // half of it, so that nothing between them is missed [px]
constexpr float kLeastContrast = 5.0F;  // standard deviation [1 of 255]

}  // namespace

cv::Mat smoothed(const cv::Mat& gray) {
  cv::Mat smooth;
  cv::GaussianBlur(gray, smooth, {9, 9}, kSmoothing);
  return smooth;
}

std::optional<PatchDescriptor> describe(const cv::Mat& smooth, const Eigen::Vector2d& pixel,
                                        double scale) {
  const double spacing = scale * kSpacing;
  const double reach = 0.5 * (kSamplesOfAnEdge - 1) * spacing;
  const Eigen::Vector2d first = pixel.array() - reach, last = pixel.array() + reach;
  if (first.minCoeff() < 0.0 || last.x() > smooth.cols - 1 || last.y() > smooth.rows - 1)
    return std::nullopt;
  PatchDescriptor descriptor;
  for (int i = 0; i < descriptor.size(); ++i) {
    const long x = std::lround(first.x() + spacing * (i % kSamplesOfAnEdge));
    const long y = std::lround(first.y() + spacing * (i / kSamplesOfAnEdge));
    descriptor(i) = smooth.at<std::uint8_t>(static_cast<int>(y), static_cast<int>(x));
  }
  descriptor.array() -= descriptor.mean();
  const float length = descriptor.norm();
  if (length < kLeastContrast * std::sqrt(static_cast<float>(descriptor.size())))
    return std::nullopt;
  return PatchDescriptor(descriptor / length);
}

}  // namespace slam::mono_ekf
