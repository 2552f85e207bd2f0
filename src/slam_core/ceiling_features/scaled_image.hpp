// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace slam::ceiling_features {

/// A spot of an image that is brighter or darker than what surrounds it.
struct Spot {
  Eigen::Vector2d pixel;  ///< its centre [px]
  double contrast = 0.0;  ///< of its logarithm of brightness to the surroundings, above 0
};

/// The logarithm of an image's brightness, smoothed by a Gaussian: there the light, which
/// multiplies all of a surface's brightness, is a constant that differences do not contain.
class ScaledImage {
 public:
  /// @param gray 8 bit, one channel
  /// @param sigma standard deviation of the Gaussian, above 0 and below the image's
  /// shorter edge; below 1 counts as 1 [px]
  ScaledImage(const cv::Mat& gray, double sigma);

  /// The spots of about the Gaussian's size, most distinct first: local maxima of the determinant
  /// of the Hessian (Lindeberg 1998, whose normalised derivatives do not depend on the scale),
  /// placed to a part of a pixel by a parabola in each direction.
  std::vector<Spot> spots(double min_contrast) const;
  /// The smoothed logarithm at a pixel, which bilinear interpolation gives.
  /// @pre the pixel is inside the image
  double at(const Eigen::Vector2d& pixel) const;

 private:
  Eigen::Vector2d toPixel(const Eigen::Vector2d& place) const;

  double reduction_;      ///< pixels of the original image per pixel here
  double sigma_;          ///< here [px]
  cv::Mat log_smoothed_;  ///< CV_32F
};

}  // namespace slam::ceiling_features
