// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "slam_core/mono_ekf/feature.hpp"

namespace slam::mono_ekf {

/// A patch that was found in an image.
struct FoundPatch {
  Eigen::Vector2d pixel;
  double correlation = 0.0;
};

/// The surroundings of a feature as they are predicted to look in an image.
class Patch {
 public:
  static constexpr int kRadius = 6;  ///< of what is compared [px]
  static constexpr int kSize = 2 * kRadius + 1;
  static constexpr int kStoredRadius = 18;  ///< of what is kept of the first image [px]

  /// Cuts out the surroundings of a pixel that are kept. The result is empty where they reach
  /// beyond the image.
  static cv::Mat cut(const cv::Mat& gray, const Eigen::Vector2d& pixel);
  /// The patch of a feature, warped to how its surface is seen now; nothing where it would be seen
  /// too differently, or shows no corner.
  /// @param J_pixel_tangents how a step along the surface moves the pixel now [px/m]
  /// @param distance between camera and surface at first sight [m]
  static std::optional<Patch> seen(const FirstSight& first, const Eigen::Matrix2d& J_pixel_tangents,
                                   double distance);

  /// The place in an ellipse where the patch correlates best with the image (normalised cross
  /// correlation), to a part of a pixel; nothing where that is not a maximum.
  /// @param S covariance of the place [px^2] @param gate largest squared Mahalanobis distance
  std::optional<FoundPatch> find(const cv::Mat& gray, const Eigen::Vector2d& predicted,
                                 const Eigen::Matrix2d& S, double gate) const;

 private:
  static constexpr int kCount = kSize * kSize;
  static constexpr int kBordered = kSize + 2;

  bool isDistinct() const;
  double correlation(const cv::Mat& gray, int x, int y) const;
  std::optional<Eigen::Vector2d> refined(const cv::Mat& gray, const Eigen::Vector2d& start) const;
  void prepareGradients();

  std::array<float, kBordered * kBordered> bordered_{};  ///< with one more pixel on each side
  std::array<std::int32_t, kCount> gray_{};
  std::int64_t sum_ = 0, square_sum_ = 0;
  std::array<float, kCount> normal_{}, gradient_x_{}, gradient_y_{};  ///< of mean 0, length 1
  Eigen::Matrix2d inverse_information_ = Eigen::Matrix2d::Zero();
};

}  // namespace slam::mono_ekf
