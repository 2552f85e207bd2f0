// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "painted_wall.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "dead_leaves.hpp"
#include "slam_core/common/random.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

constexpr int kPlasterEdge = 512;      // [texels]
constexpr double kSmallestLeaf = 2.0;  // [texels]

/// Values drawn within bounds.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed, 0) {}
  double between(double low, double high) { return low + (high - low) * random_.uniform(); }
  /// Uniform in the logarithm: as many small as large ones.
  double scale(double low, double high) { return low * std::pow(high / low, random_.uniform()); }

 private:
  RandomStream random_;
};

cv::Mat plasterCanvas(cv::Size size, std::uint64_t seed) {
  const cv::Mat plaster = plasterTexture(kPlasterEdge, seed);
  cv::Mat canvas;
  cv::repeat(plaster, size.height / kPlasterEdge + 1, size.width / kPlasterEdge + 1, canvas);
  canvas(cv::Rect({0, 0}, size)).convertTo(canvas, CV_32F);
  return canvas;
}

/// Damp spots: soft and wide, which is what is left of a wall from afar.
void stain(cv::Mat& wall, double texels_per_metre, Dice& draw) {
  const int count = std::max(1, static_cast<int>(wall.cols / texels_per_metre));
  for (int i = 0; i < count; ++i) {
    const double radius = draw.scale(0.1, 0.5) * texels_per_metre;
    const cv::Point at(static_cast<int>(draw.between(0.0, wall.cols)),
                       static_cast<int>(draw.between(0.0, wall.rows)));
    const cv::Size axes(static_cast<int>(radius),
                        static_cast<int>(radius * draw.between(0.4, 1.0)));
    const cv::Rect around =
        cv::Rect(at.x - 3 * axes.width, at.y - 3 * axes.width, 6 * axes.width, 6 * axes.width) &
        cv::Rect({0, 0}, wall.size());
    if (around.empty()) continue;
    cv::Mat spot = cv::Mat::zeros(around.size(), CV_32F);
    cv::ellipse(spot, at - around.tl(), axes, draw.between(0.0, 180.0), 0, 360,
                draw.between(15.0, 45.0), cv::FILLED);
    cv::GaussianBlur(spot, spot, cv::Size(), radius / 3.0);
    wall(around) -= spot;
  }
}

/// A poster: a frame and a picture with detail at all scales.
void hang(cv::Mat& wall, const cv::Rect& place, double texels_per_metre, Dice& draw,
          std::uint64_t seed) {
  const double frame = draw.between(20.0, 250.0);
  wall(place).setTo(frame);
  const int rim = std::max(2, static_cast<int>(0.02 * texels_per_metre));
  const cv::Rect inner(place.x + rim, place.y + rim, place.width - 2 * rim, place.height - 2 * rim);
  if (inner.width < 8 || inner.height < 8) return;
  const double darkest = draw.between(10.0, 110.0), brightest = draw.between(150.0, 250.0);
  const double largest = std::min(inner.width, inner.height) / 3.0;
  deadLeaves(inner.size(), {kSmallestLeaf, std::max(largest, 3.0), darkest, brightest}, seed)
      .copyTo(wall(inner));
}

void hangPosters(cv::Mat& wall, double texels_per_metre, Dice& draw, std::uint64_t seed) {
  const double width = wall.cols / texels_per_metre, height = wall.rows / texels_per_metre;
  const auto texels = [&](double metres) { return static_cast<int>(metres * texels_per_metre); };
  std::uint64_t number = 0;
  double at = draw.between(0.05, 0.4);
  while (at < width - 0.25) {  // column by column
    const double widest = std::min(draw.scale(0.3, 1.2), width - at - 0.05);
    double top = draw.between(0.05, 0.6);
    while (true) {
      const double wide = widest * draw.scale(0.5, 1.0), tall = wide * draw.scale(0.6, 1.4);
      const double left = at + draw.between(0.0, widest - wide);
      if (top + tall > height - 0.15) break;
      hang(wall, {texels(left), texels(top), texels(wide), texels(tall)}, texels_per_metre, draw,
           seed + ++number);
      top += tall + draw.scale(0.05, 0.5);
    }
    at += widest + draw.scale(0.05, 0.5);
  }
}

/// All of a wall; a surface must not reach beyond its picture.
cv::Size canvasOf(double width, double height) {
  const double texels_per_metre = paintedTexelsPerMetre(width, height);
  const auto texels = [&](double metres) {
    return std::max(8, static_cast<int>(std::ceil(metres * texels_per_metre)));
  };
  return {texels(width), texels(height)};
}

cv::Mat softened(const cv::Mat& values) {
  cv::Mat gray;
  cv::GaussianBlur(values, gray, cv::Size(), 0.7);
  gray.convertTo(gray, CV_8U);
  return gray;
}

}  // namespace

double paintedTexelsPerMetre(double width, double height) {
  return std::min(kPaintedTexelsPerMetre, kMostPaintedTexels / std::max(width, height));
}

cv::Mat posterWall(double width, double height, std::uint64_t seed) {
  const double texels_per_metre = paintedTexelsPerMetre(width, height);
  Dice draw(seed);
  cv::Mat wall = plasterCanvas(canvasOf(width, height), seed);
  stain(wall, texels_per_metre, draw);
  hangPosters(wall, texels_per_metre, draw, seed);
  return softened(wall);
}

cv::Mat muralWall(double width, double height, std::uint64_t seed) {
  const LeafRange leaves{kSmallestLeaf, 0.6 * paintedTexelsPerMetre(width, height), 60.0, 250.0};
  return softened(deadLeaves(canvasOf(width, height), leaves, seed));
}

cv::Mat doorLeaf(double width, double height) {
  cv::Mat door(canvasOf(width, height), CV_32F, cv::Scalar(70.0));  // the frame
  const auto at = [&](double x, double y, double w, double h) {
    return cv::Rect(static_cast<int>(x * door.cols), static_cast<int>(y * door.rows),
                    static_cast<int>(w * door.cols), static_cast<int>(h * door.rows));
  };
  door(at(0.08, 0.04, 0.84, 0.96)).setTo(150.0);
  for (const double top : {0.52, 0.76}) {
    door(at(0.2, top, 0.6, 0.19)).setTo(115.0);
    door(at(0.23, top + 0.015, 0.54, 0.16)).setTo(165.0);
  }
  door(at(0.3, 0.12, 0.4, 0.3)).setTo(40.0);  // a window with a bar
  door(at(0.48, 0.12, 0.04, 0.3)).setTo(150.0);
  door(at(0.12, 0.5, 0.1, 0.02)).setTo(235.0);  // the handle
  door(at(0.12, 0.48, 0.04, 0.06)).setTo(235.0);
  return softened(door);
}

}  // namespace slam::sim
