// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dead_leaves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "slam_core/common/random.hpp"

namespace slam::sim {
namespace {

constexpr double kCoverage = 2.5;    // leaves' area over the canvas': little of the ground is left
constexpr double kBandLimit = 0.7;   // standard deviation of the blur [texels]
constexpr double kMostOblong = 3.0;  // long over short axis of a leaf

struct Leaf {
  cv::Point2f centre;
  cv::Size2f size;  ///< [texels]
  float angle;      ///< [degree]
  double gray;
  bool is_round;
};

/// A radius of the density r^-3 within the range, by inversion.
double radiusOf(const LeafRange& range, double uniform) {
  const double most = std::pow(range.smallest, -2.0), least = std::pow(range.largest, -2.0);
  return 1.0 / std::sqrt(most - uniform * (most - least));
}

int countOf(cv::Size canvas, const LeafRange& range) {
  const double mean_square =
      2.0 * range.smallest * range.smallest * std::log(range.largest / range.smallest);
  return static_cast<int>(kCoverage * canvas.area() / (M_PI * mean_square));
}

Leaf drawnLeaf(cv::Size canvas, const LeafRange& range, RandomStream& random) {
  const double x = random.uniform() * canvas.width, y = random.uniform() * canvas.height;
  const double radius = radiusOf(range, random.uniform());
  const double oblong = std::sqrt(1.0 + (kMostOblong - 1.0) * random.uniform());
  const double angle = 360.0 * random.uniform();
  const double gray = range.darkest + (range.brightest - range.darkest) * random.uniform();
  return {{static_cast<float>(x), static_cast<float>(y)},
          {static_cast<float>(2.0 * radius * oblong), static_cast<float>(2.0 * radius / oblong)},
          static_cast<float>(angle),
          gray,
          random.uniform() < 0.5};
}

void paint(cv::Mat& canvas, const Leaf& leaf, const cv::Point2f& shift) {
  const cv::RotatedRect place(leaf.centre + shift, leaf.size, leaf.angle);
  if (leaf.is_round) {
    cv::ellipse(canvas, place, leaf.gray, cv::FILLED);
    return;
  }
  std::array<cv::Point2f, 4> corners;
  place.points(corners.data());
  std::vector<cv::Point> polygon(corners.begin(), corners.end());
  cv::fillConvexPoly(canvas, polygon, leaf.gray);
}

/// The leaf again on the other side, where it sticks out.
void paintWrapped(cv::Mat& canvas, const Leaf& leaf) {
  const float reach = std::max(leaf.size.width, leaf.size.height);
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      const cv::Point2f shift(static_cast<float>(x * canvas.cols),
                              static_cast<float>(y * canvas.rows));
      const cv::Point2f at = leaf.centre + shift;
      if (at.x > -reach && at.y > -reach && at.x < static_cast<float>(canvas.cols) + reach &&
          at.y < static_cast<float>(canvas.rows) + reach) {
        paint(canvas, leaf, shift);
      }
    }
  }
}

}  // namespace

cv::Mat deadLeaves(cv::Size size, const LeafRange& range, std::uint64_t seed) {
  const int rim = 4;  // [texels], so that the blur closes as well
  cv::Mat canvas(size, CV_32F, cv::Scalar((range.darkest + range.brightest) / 2.0));
  RandomStream random(seed, 0);
  const int count = countOf(size, range);
  for (int i = 0; i < count; ++i) paintWrapped(canvas, drawnLeaf(size, range, random));
  cv::Mat wide, blurred;
  cv::copyMakeBorder(canvas, wide, rim, rim, rim, rim, cv::BORDER_WRAP);
  cv::GaussianBlur(wide, blurred, cv::Size(), kBandLimit);
  return blurred(cv::Rect({rim, rim}, size)).clone();
}

}  // namespace slam::sim
