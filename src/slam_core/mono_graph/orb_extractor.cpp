// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/orb_extractor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/features2d.hpp>
#include <tuple>

namespace slam::mono_graph {
namespace {

constexpr int kColumns = 10, kRows = 8;  // cells of an image
constexpr int kFastThreshold = 12;       // [1 of 255]
constexpr int kSurplus = 3;              // so many times more are found than kept
constexpr int kPatch = 31;               // [px] that a descriptor compares

cv::Ptr<cv::ORB> makeOrb(int count) {
  return cv::ORB::create(count, static_cast<float>(kPyramidScale), kPyramidLevels, kPatch, 0, 2,
                         cv::ORB::HARRIS_SCORE, kPatch, kFastThreshold);
}

/// Harris's measure comes of gradients of one level: those of different levels are not compared by
/// it alone, so that the coarse ones have their share.
bool isBefore(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  const auto key = [](const cv::KeyPoint& k) {
    return std::make_tuple(-k.response, k.pt.y, k.pt.x, k.octave);
  };
  return key(a) < key(b);
}

std::size_t cellAt(const cv::Point2f& at, const cv::Size& size) {
  const int column = std::min(kColumns - 1, static_cast<int>(at.x) * kColumns / size.width);
  const int row = std::min(kRows - 1, static_cast<int>(at.y) * kRows / size.height);
  return static_cast<std::size_t>(row * kColumns + column);
}

/// The strongest ones of each cell; what cells with few leave over is left over.
std::vector<cv::KeyPoint> spread(std::vector<cv::KeyPoint> keypoints, const cv::Size& size,
                                 int count) {
  std::sort(keypoints.begin(), keypoints.end(), isBefore);
  const int most = std::max(1, 2 * count / (kColumns * kRows));
  std::vector<int> in_cell(kColumns * kRows, 0);
  std::vector<cv::KeyPoint> kept;
  for (const auto& keypoint : keypoints) {
    if (kept.size() >= static_cast<std::size_t>(count)) break;
    if (in_cell[cellAt(keypoint.pt, size)]++ < most) kept.push_back(keypoint);
  }
  return kept;
}

}  // namespace

std::vector<cv::KeyPoint> OrbExtractor::describe(const cv::Mat& gray,
                                                 std::vector<Descriptor>& found) const {
  std::vector<cv::KeyPoint> keypoints;
  const auto orb = makeOrb(kSurplus * count_);
  orb->detect(gray, keypoints);
  keypoints = spread(std::move(keypoints), gray.size(), count_);
  cv::Mat descriptors;
  orb->compute(gray, keypoints, descriptors);
  found.resize(keypoints.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    std::memcpy(found[i].data(), descriptors.ptr(static_cast<int>(i)), sizeof(Descriptor));
  return keypoints;
}

Features OrbExtractor::extract(const CameraView& view) const {
  std::vector<Descriptor> descriptors;
  const auto keypoints = describe(view.image.gray, descriptors);
  const auto& calibration = view.camera->calibration();
  const double focal = std::sqrt(calibration.fx * calibration.fy);
  std::vector<Feature> features;
  features.reserve(keypoints.size());
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    const auto& keypoint = keypoints[i];
    const Eigen::Vector2d pixel(keypoint.pt.x, keypoint.pt.y);
    const auto seen = view.camera->unproject(pixel);
    if (!seen) continue;
    const double sigma = sigma_ * std::pow(kPyramidScale, keypoint.octave) / focal;
    features.push_back(
        {*seen, pixel, sigma, keypoint.angle * M_PI / 180.0, keypoint.octave, descriptors[i]});
  }
  return {std::move(features), NormalisedCamera(view.mount.T_base_camera), focal};
}

}  // namespace slam::mono_graph
