// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/ring_descriptor.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/ceiling_features/ring.hpp"

namespace slam::ceiling_features {
namespace {

constexpr int kRings = Descriptor::kMostElements / 2;
/// The numbers of one point differ by so much from view to view, in the logarithm of the
/// brightness: the light's direction, the lens's shading, the sampling of the rings.
constexpr float kSigma = 0.03F;

struct Ring {
  double mean = 0.0, deviation = 0.0;
};

std::optional<Ring> ringOf(const ScaledImage& image, const cv::Size& size, const CeilingView& view,
                           const Eigen::Vector2d& point, double radius) {
  const auto pixels = pixelsOfRing(view, point, radius, size);
  if (!pixels) return std::nullopt;
  double sum = 0.0, squares = 0.0;
  for (const auto& pixel : *pixels) {
    const double value = image.at(pixel);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kRingPixels;
  return Ring{mean, std::sqrt(std::max(0.0, squares / kRingPixels - mean * mean))};
}

}  // namespace

std::optional<Descriptor> describeSurroundings(const ScaledImage& image, const cv::Size& size,
                                               const CeilingView& view,
                                               const Eigen::Vector2d& point, double radius) {
  Descriptor descriptor{Descriptor::Vector(2 * kRings),
                        Descriptor::Vector::Constant(2 * kRings, kSigma)};
  for (int i = 0; i < kRings; ++i) {
    const auto ring = ringOf(image, size, view, point, radius * (kRings - i) / kRings);
    if (!ring) return std::nullopt;
    descriptor.values(i) = static_cast<float>(ring->mean);
    descriptor.values(kRings + i) = static_cast<float>(ring->deviation);
  }
  descriptor.values.head(kRings).array() -= descriptor.values.head(kRings).mean();
  return descriptor;
}

}  // namespace slam::ceiling_features
