// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/scaled_image.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace slam::ceiling_features {
namespace {

constexpr double kFinestSigma = 1.0;   // a Gaussian that pixels still sample [px]
constexpr double kWorkingSigma = 2.5;  // a wider one gains nothing over a smaller image [px]
constexpr int kLeastEdge = 3;          // of an image that may have a spot [px]
/// A spot whose profile is the Gaussian itself has a contrast of so many times its response, since
/// smoothing flattens it to half its height.
constexpr double kContrastOfResponse = 4.0;
constexpr float kDarkCurrent =
    4.0F;  // keeps the noise of a dark image's logarithm bounded [of 255]

/// The offset of a parabola's vertex from the middle one of three samples, where that is the
/// largest.
double vertex(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  if (curvature >= 0.0) return 0.0;
  return std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5);
}

bool isLocalMaximum(const cv::Mat& field, int y, int x) {
  const float value = field.at<float>(y, x);
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) {
      const bool is_before = v < 0 || (v == 0 && u < 0);
      const float other = field.at<float>(y + v, x + u);
      if (other > value || (is_before && other == value)) return false;
    }
  return true;
}

/// The determinant of the Hessian, from normalised second derivatives, and how round a spot it is
/// the top of: the ratio of the lesser curvature to the greater one. Where the determinant is not
/// positive the image has a saddle or an edge.
struct HessianField {
  HessianField(const cv::Mat& image, double sigma) {
    const double normalised = 0.25 * sigma * sigma;  // Sobel's kernels of second order sum up to 4
    cv::Mat xx, yy, xy;
    cv::Sobel(image, xx, CV_32F, 2, 0, 3, normalised, 0.0, cv::BORDER_REPLICATE);
    cv::Sobel(image, yy, CV_32F, 0, 2, 3, normalised, 0.0, cv::BORDER_REPLICATE);
    cv::Sobel(image, xy, CV_32F, 1, 1, 3, normalised, 0.0, cv::BORDER_REPLICATE);
    determinant = xx.mul(yy) - xy.mul(xy);
    trace = xx + yy;
  }

  bool isRound(int y, int x) const {
    constexpr float kLeastRatio = 0.4F;  // what is longer is placed less exactly along it
    const float t = trace.at<float>(y, x);
    const float bound = kLeastRatio / ((1.0F + kLeastRatio) * (1.0F + kLeastRatio));
    return determinant.at<float>(y, x) >= bound * t * t;
  }

  cv::Mat determinant, trace;  ///< CV_32F
};

}  // namespace

ScaledImage::ScaledImage(const cv::Mat& gray, double sigma) {
  sigma = std::max(sigma, kFinestSigma);
  const double most = std::max(1, std::min(gray.cols, gray.rows) / kLeastEdge);
  reduction_ = std::clamp(std::floor(sigma / kWorkingSigma), 1.0, most);
  sigma_ = sigma / reduction_;
  const int step = static_cast<int>(reduction_);
  const cv::Size size(gray.cols / step, gray.rows / step);
  cv::Mat image;
  gray({0, 0, size.width * step, size.height * step}).convertTo(image, CV_32F, 1.0, kDarkCurrent);
  if (step > 1) cv::resize(image, image, size, 0.0, 0.0, cv::INTER_AREA);
  cv::log(image, image);
  cv::GaussianBlur(image, log_smoothed_, {}, sigma_, sigma_, cv::BORDER_REPLICATE);
}

std::vector<Spot> ScaledImage::spots(double min_contrast) const {
  const HessianField hessian(log_smoothed_, sigma_);
  const auto& field = hessian.determinant;
  const double response = min_contrast / kContrastOfResponse;
  const auto least = static_cast<float>(response * response);
  std::vector<Spot> found;
  for (int y = 1; y < field.rows - 1; ++y)
    for (int x = 1; x < field.cols - 1; ++x) {
      const float value = field.at<float>(y, x);
      if (!(value >= least) || !isLocalMaximum(field, y, x) || !hessian.isRound(y, x)) continue;
      const double dx = vertex(field.at<float>(y, x - 1), value, field.at<float>(y, x + 1));
      const double dy = vertex(field.at<float>(y - 1, x), value, field.at<float>(y + 1, x));
      found.push_back({toPixel({x + dx, y + dy}), kContrastOfResponse * std::sqrt(value)});
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const Spot& a, const Spot& b) { return a.contrast > b.contrast; });
  return found;
}

double ScaledImage::at(const Eigen::Vector2d& pixel) const {
  const auto place = [this](double p, int size) {
    return std::clamp((p + 0.5) / reduction_ - 0.5, 0.0, size - 1.001);
  };
  const double x = place(pixel.x(), log_smoothed_.cols), y = place(pixel.y(), log_smoothed_.rows);
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  const double u = x - left, v = y - top;
  const auto* upper = log_smoothed_.ptr<float>(top) + left;
  const auto* lower = log_smoothed_.ptr<float>(top + 1) + left;
  return (1.0 - v) * ((1.0 - u) * upper[0] + u * upper[1]) +
         v * ((1.0 - u) * lower[0] + u * lower[1]);
}

Eigen::Vector2d ScaledImage::toPixel(const Eigen::Vector2d& place) const {
  return (place.array() + 0.5) * reduction_ - 0.5;
}

}  // namespace slam::ceiling_features
