// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/patch.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace slam::mono_ekf {
namespace {

/// Bilinear. @pre the four pixels around are there
float sampleAt(const cv::Mat& gray, double x, double y) {
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const float fx = static_cast<float>(x - column), fy = static_cast<float>(y - row);
  const auto* upper = gray.ptr<std::uint8_t>(row) + column;
  const auto* lower = gray.ptr<std::uint8_t>(row + 1) + column;
  const float above =
      static_cast<float>(upper[0]) * (1.0F - fx) + static_cast<float>(upper[1]) * fx;
  const float below =
      static_cast<float>(lower[0]) * (1.0F - fx) + static_cast<float>(lower[1]) * fx;
  return above * (1.0F - fy) + below * fy;
}

bool holds(const cv::Mat& gray, double x, double y) {
  return x >= 0.0 && y >= 0.0 && x < gray.cols - 1.0 && y < gray.rows - 1.0;
}

/// Whether the surface is seen neither too much larger or smaller nor too obliquely.
bool isAlike(const Eigen::Matrix2d& A_first_now) {
  constexpr double kLargestScale = 2.0, kLargestStretch = 2.5;
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(A_first_now);
  const double larger = svd.singularValues()(0), smaller = svd.singularValues()(1);
  return std::isfinite(larger) && larger <= kLargestScale && smaller >= 1.0 / kLargestScale &&
         larger <= kLargestStretch * smaller;
}

}  // namespace

cv::Mat Patch::cut(const cv::Mat& gray, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(std::lround(pixel.x())) - kStoredRadius;
  const int y = static_cast<int>(std::lround(pixel.y())) - kStoredRadius;
  const cv::Rect part(x, y, 2 * kStoredRadius + 1, 2 * kStoredRadius + 1);
  const cv::Rect whole({}, gray.size());
  return (part & whole) == part ? gray(part).clone() : cv::Mat();
}

std::optional<Patch> Patch::seen(const FirstSight& first, const Eigen::Matrix2d& J_pixel_tangents,
                                 double distance) {
  const Eigen::Matrix2d A_first_now =
      first.J_pixel_tangents / distance * J_pixel_tangents.inverse();
  if (!isAlike(A_first_now)) return std::nullopt;
  Patch patch;
  for (int row = 0; row < kBordered; ++row)
    for (int column = 0; column < kBordered; ++column) {
      const Eigen::Vector2d now(column - kRadius - 1, row - kRadius - 1);
      const Eigen::Vector2d at = (A_first_now * now).array() + double{kStoredRadius};
      if (!holds(first.patch, at.x(), at.y())) return std::nullopt;
      patch.bordered_[std::size_t(row * kBordered + column)] =
          sampleAt(first.patch, at.x(), at.y());
    }
  patch.prepareGradients();
  if (!patch.isDistinct()) return std::nullopt;
  return patch;
}

void Patch::prepareGradients() {
  const auto at = [&](int row, int column) {
    return bordered_[std::size_t((row + 1) * kBordered + column + 1)];
  };
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const auto i = std::size_t(row * kSize + column);
      gray_[i] = static_cast<std::int32_t>(std::lround(at(row, column)));
      sum_ += gray_[i];
      square_sum_ += std::int64_t{gray_[i]} * gray_[i];
      normal_[i] = at(row, column);
      gradient_x_[i] = 0.5F * (at(row, column + 1) - at(row, column - 1));
      gradient_y_[i] = 0.5F * (at(row + 1, column) - at(row - 1, column));
    }
  Eigen::Map<Eigen::ArrayXf> normal(normal_.data(), kCount), gradient_x(gradient_x_.data(), kCount),
      gradient_y(gradient_y_.data(), kCount);
  normal -= normal.mean();
  const float length = std::max(normal.matrix().norm(), 1e-6F);
  normal /= length;
  gradient_x /= length;
  gradient_y /= length;
  Eigen::Matrix2d information;
  information << (gradient_x * gradient_x).sum(), (gradient_x * gradient_y).sum(),
      (gradient_x * gradient_y).sum(), (gradient_y * gradient_y).sum();
  inverse_information_ = information.inverse();
}

/// A patch along an edge could slide along it.
bool Patch::isDistinct() const {
  constexpr double kLeastDeviation = 5.0;  // [1 of 255], above the noise of most cameras
  constexpr double kLeastRatio = 0.12;     // of the information across and along an edge
  const double mean = static_cast<double>(sum_) / kCount;
  const double variance = static_cast<double>(square_sum_) / kCount - mean * mean;
  if (!(variance > kLeastDeviation * kLeastDeviation) || !inverse_information_.allFinite())
    return false;
  const double trace = inverse_information_.trace();
  const double shape = inverse_information_.determinant() / (trace * trace);
  return shape >= kLeastRatio / ((1.0 + kLeastRatio) * (1.0 + kLeastRatio));
}

/// @pre the window lies in the image
double Patch::correlation(const cv::Mat& gray, int x, int y) const {
  std::int32_t cross = 0, sum = 0, square_sum = 0;
  for (int row = 0; row < kSize; ++row) {
    const auto* window = gray.ptr<std::uint8_t>(y - kRadius + row) + x - kRadius;
    const auto* mine = &gray_[std::size_t(row * kSize)];
    for (int column = 0; column < kSize; ++column) {
      const std::int32_t value = window[column];
      cross += value * mine[column];
      sum += value;
      square_sum += value * value;
    }
  }
  const double variance = static_cast<double>(square_sum) * kCount - static_cast<double>(sum) * sum;
  const double own = static_cast<double>(square_sum_) * kCount -
                     static_cast<double>(sum_) * static_cast<double>(sum_);
  if (variance <= 0.0) return 0.0;
  return (static_cast<double>(cross) * kCount - static_cast<double>(sum_) * sum) /
         std::sqrt(variance * own);
}

std::optional<FoundPatch> Patch::find(const cv::Mat& gray, const Eigen::Vector2d& predicted,
                                      const Eigen::Matrix2d& S, double gate) const {
  const Eigen::Matrix2d information = S.inverse();
  const Eigen::Array2d reach = (gate * S.diagonal().array()).sqrt();
  const int left = std::max(static_cast<int>(std::ceil(predicted.x() - reach.x())), kRadius);
  const int top = std::max(static_cast<int>(std::ceil(predicted.y() - reach.y())), kRadius);
  const int right =
      std::min(static_cast<int>(std::floor(predicted.x() + reach.x())), gray.cols - 1 - kRadius);
  const int bottom =
      std::min(static_cast<int>(std::floor(predicted.y() + reach.y())), gray.rows - 1 - kRadius);
  double best = 0.0;
  Eigen::Vector2d at = predicted;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const Eigen::Vector2d pixel(x, y);
      const Eigen::Vector2d error = pixel - predicted;
      if (error.dot(information * error) > gate) continue;
      const double value = correlation(gray, x, y);
      if (value <= best) continue;
      best = value;
      at = pixel;
    }
  if (best <= 0.0) return std::nullopt;
  const auto exact = refined(gray, at);
  if (!exact) return std::nullopt;
  return FoundPatch{*exact, best};
}

/// Gauss and Newton's method with the patch's own gradients; light is taken out at each step.
std::optional<Eigen::Vector2d> Patch::refined(const cv::Mat& gray,
                                              const Eigen::Vector2d& start) const {
  constexpr int kMostIterations = 8;
  constexpr double kSmallStep = 0.01, kLargestShift = 1.5;  // [px]
  Eigen::Vector2d at = start;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    if (!holds(gray, at.x() - kRadius, at.y() - kRadius) ||
        !holds(gray, at.x() + kRadius, at.y() + kRadius))
      return std::nullopt;
    Eigen::Array<float, kCount, 1> window;
    for (int i = 0; i < kCount; ++i)
      window(i) = sampleAt(gray, at.x() + i % kSize - kRadius, at.y() + i / kSize - kRadius);
    window -= window.mean();
    window /= std::max(window.matrix().norm(), 1e-6F);
    const Eigen::Map<const Eigen::Array<float, kCount, 1>> normal(normal_.data()),
        gradient_x(gradient_x_.data()), gradient_y(gradient_y_.data());
    const Eigen::Vector2d slope((gradient_x * (normal - window)).sum(),
                                (gradient_y * (normal - window)).sum());
    const Eigen::Vector2d step = inverse_information_ * slope;
    at += step;
    if (!((at - start).norm() < kLargestShift)) return std::nullopt;
    if (step.norm() < kSmallStep) break;
  }
  return at;
}

}  // namespace slam::mono_ekf
