// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/described_features.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <opencv2/core/hal/hal.hpp>
#include <tuple>

namespace slam::visual_odometry {
namespace {

/// The keypoints' order does not tell in which order threads found them.
std::vector<int> orderOf(const std::vector<cv::KeyPoint>& keypoints) {
  std::vector<int> order(keypoints.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    const auto& k = keypoints[static_cast<std::size_t>(i)];
    return std::make_tuple(k.pt.y, k.pt.x, k.size, k.angle);
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  return order;
}

double distance(const cv::Mat& a, int row_a, const cv::Mat& b, int row_b) {
  if (a.type() == CV_8U)
    return cv::hal::normHamming(a.ptr<uchar>(row_a), b.ptr<uchar>(row_b), a.cols);
  return std::sqrt(
      static_cast<double>(cv::hal::normL2Sqr_(a.ptr<float>(row_a), b.ptr<float>(row_b), a.cols)));
}

/// For a feature the nearest one of the other image.
struct Nearest {
  double distance = std::numeric_limits<double>::max();
  int index = -1;

  void consider(double candidate, int i) {
    if (candidate < distance) *this = {candidate, i};
  }
};

}  // namespace

Features DescribedFeatures::extract(const cv::Mat& gray, const CeilingView& view) {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
  detector_->detect(gray, keypoints, descriptors);
  Features features;
  for (const int i : orderOf(keypoints)) {
    const auto& keypoint = keypoints[static_cast<std::size_t>(i)];
    const Eigen::Vector2d pixel(keypoint.pt.x, keypoint.pt.y);
    const auto point = view.toCeiling(pixel);
    if (!point) continue;
    features.pixels.push_back(pixel);
    features.points.push_back(*point);
    features.sigmas.push_back(detector_->coarseness(keypoint));
    features.descriptors.push_back(descriptors.row(i));
  }
  return features;
}

PointMatches DescribedFeatures::match(const Features& reference, const Features& now,
                                      const CeilingView& view, const SearchWindow& window) const {
  std::vector<Nearest> of_now(now.size()), of_reference(reference.size());
  for (std::size_t j = 0; j < now.size(); ++j) {
    const Eigen::Vector2d expected = window.T_reference_now.transform(now.points[j]);
    const double radius = window.radius(now.points[j]), radius2 = radius * radius;
    for (std::size_t i = 0; i < reference.size(); ++i) {
      if ((reference.points[i] - expected).squaredNorm() > radius2) continue;
      const int row = static_cast<int>(i), row_now = static_cast<int>(j);
      const double d = distance(reference.descriptors, row, now.descriptors, row_now);
      of_now[j].consider(d, row);
      of_reference[i].consider(d, row_now);
    }
  }
  PointMatches matches;
  for (std::size_t j = 0; j < now.size(); ++j) {
    if (of_now[j].index < 0 || of_now[j].distance > detector_->maxDistance()) continue;
    const auto i = static_cast<std::size_t>(of_now[j].index);
    if (of_reference[i].index != static_cast<int>(j)) continue;
    const double sigma = std::hypot(reference.sigmas[i], now.sigmas[j]) * view.metresPerPixel();
    matches.push_back(
        {reference.pixels[i], now.pixels[j], reference.points[i], now.points[j], sigma});
  }
  return matches;
}

}  // namespace slam::visual_odometry
