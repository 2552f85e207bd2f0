// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/camera/ceiling_view.hpp"
#include "slam_core/camera/mat_archive.hpp"
#include "slam_core/visual_odometry/point_match.hpp"
#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// What is kept of an image to match it with others. The first three have an entry for each
/// feature.
struct Features {
  std::vector<Eigen::Vector2d> pixels;  ///< [px]
  std::vector<Eigen::Vector2d> points;  ///< on the ceiling, in the base frame [m]
  std::vector<double> sigmas;           ///< of a pixel in each direction, up to a common factor
  cv::Mat descriptors;                  ///< a row each; empty where features are tracked
  std::vector<cv::Mat> pyramid;         ///< of the image, where features are tracked

  std::size_t size() const { return pixels.size(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(pixels, points, sigmas);
    persistMat(archive, descriptors);
    auto levels = std::uint64_t{pyramid.size()};
    archive.count(levels);
    if constexpr (Archive::kReads) pyramid.resize(levels);
    for (auto& level : pyramid) persistMat(archive, level);
  }
};

/// How points of the ceiling are found again in another image: by what surrounds them (descriptors)
/// or by tracking. All give the same for any number of threads.
class FeaturePolicy {
 public:
  virtual ~FeaturePolicy() = default;

  /// Whether extract() tells how many features there are.
  virtual bool countsFeatures() const = 0;
  /// Variance of a motion over what independent matches would give: neighbours share pixels, and
  /// with them their noise. From a Monte Carlo over rendered ceilings.
  virtual double dependence() const = 0;
  /// @param gray 8 bit, one channel
  virtual Features extract(const cv::Mat& gray, const CeilingView& view) = 0;
  /// To be called before the features are a reference of match().
  virtual void prepareReference(Features& features, const CeilingView& view) const = 0;
  /// Each feature is in one match at most.
  virtual PointMatches match(const Features& reference, const Features& now,
                             const CeilingView& view, const SearchWindow& window) const = 0;
};

/// @param max_features of an image
/// @throw ConfigError when the installed OpenCV does not have it, with the nearest
std::unique_ptr<FeaturePolicy> makeFeaturePolicy(FeatureKind kind, int max_features);

}  // namespace slam::visual_odometry
