// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/keypoint_detector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/features2d.hpp>

#include "slam_core/common/config_error.hpp"
#if __has_include(<opencv2/xfeatures2d/nonfree.hpp>)
#include <opencv2/xfeatures2d/nonfree.hpp>
#define SLAM_HAS_SURF
#endif

namespace slam::visual_odometry {
namespace {

/// FAST corners on a pyramid; where the image is too dull for that, with a lower threshold.
class Orb final : public KeypointDetector {
 public:
  explicit Orb(int max_features)
      : few_(static_cast<std::size_t>(max_features / 4)),
        orb_(make(max_features, 20)),
        sensitive_orb_(make(max_features, 7)) {}

  void detect(const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints,
              cv::Mat& descriptors) override {
    orb_->detectAndCompute(gray, cv::noArray(), keypoints, descriptors);
    if (keypoints.size() >= few_) return;
    sensitive_orb_->detectAndCompute(gray, cv::noArray(), keypoints, descriptors);
  }
  double coarseness(const cv::KeyPoint& keypoint) const override {
    return std::pow(kScale, keypoint.octave);
  }
  double maxDistance() const override { return 64.0; }
  double dependence() const override { return 1.5; }

 private:
  static constexpr float kScale = 1.2F;
  static constexpr int kLevels = 5;

  static cv::Ptr<cv::ORB> make(int max_features, int threshold) {
    return cv::ORB::create(max_features, kScale, kLevels, 31, 0, 2, cv::ORB::HARRIS_SCORE, 31,
                           threshold);
  }

  std::size_t few_;
  cv::Ptr<cv::ORB> orb_, sensitive_orb_;
};

/// The strongest keypoints; equal ones in the order of their place.
void keepStrongest(std::vector<cv::KeyPoint>& keypoints, int count) {
  const auto is_stronger = [](const cv::KeyPoint& a, const cv::KeyPoint& b) {
    if (a.response != b.response) return a.response > b.response;
    return a.pt.y != b.pt.y ? a.pt.y < b.pt.y : a.pt.x < b.pt.x;
  };
  std::sort(keypoints.begin(), keypoints.end(), is_stronger);
  if (keypoints.size() > static_cast<std::size_t>(count))
    keypoints.resize(static_cast<std::size_t>(count));
}

/// Any of OpenCV's detectors that has no limit of its own.
class Strongest final : public KeypointDetector {
 public:
  Strongest(cv::Ptr<cv::Feature2D> features, int max_features, double max_distance,
            double dependence)
      : features_(std::move(features)),
        max_features_(max_features),
        max_distance_(max_distance),
        dependence_(dependence) {}

  void detect(const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints,
              cv::Mat& descriptors) override {
    features_->detect(gray, keypoints);
    keepStrongest(keypoints, max_features_);
    features_->compute(gray, keypoints, descriptors);
  }
  double coarseness(const cv::KeyPoint& keypoint) const override {
    const auto octave = static_cast<std::int8_t>(keypoint.octave & 255);  // as SIFT packs it
    return std::ldexp(1.0, std::max<int>(octave, 0));
  }
  double maxDistance() const override { return max_distance_; }
  double dependence() const override { return dependence_; }

 private:
  cv::Ptr<cv::Feature2D> features_;
  int max_features_;
  double max_distance_, dependence_;
};

std::unique_ptr<KeypointDetector> makeSurf([[maybe_unused]] int max_features) {
#ifdef SLAM_HAS_SURF
  try {
    return std::make_unique<Strongest>(cv::xfeatures2d::SURF::create(100.0), max_features, 0.4,
                                       3.0);
  } catch (const cv::Exception&) {
    // built without its patented parts, although the header is there
  }
#endif
  throw ConfigError(
      "visual_odometry.features: surf is not part of the installed OpenCV, which was built without "
      "its non-free modules; the nearest is sift, the fastest orb");
}

}  // namespace

std::unique_ptr<KeypointDetector> makeKeypointDetector(FeatureKind kind, int max_features) {
  if (kind == FeatureKind::kSurf) return makeSurf(max_features);
  if (kind == FeatureKind::kAkaze)
    return std::make_unique<Strongest>(cv::AKAZE::create(), max_features, 120.0, 2.0);
  if (kind == FeatureKind::kSift)
    return std::make_unique<Strongest>(cv::SIFT::create(), max_features, 300.0, 4.5);
  return std::make_unique<Orb>(max_features);
}

}  // namespace slam::visual_odometry
