// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/camera_rays.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "sample_pattern.hpp"
#include "slam_core/camera/camera_model.hpp"
#include "slam_core/common/random.hpp"

namespace slam::sim {
namespace {

constexpr std::uint64_t kShiftSeed = 16;

/// The image points on the plane z = 1 of the corners of all pixels.
class CornerRays {
 public:
  CornerRays(const CameraCalibration& camera, int columns, int rows) : columns_(columns + 1) {
    const slam::CameraModel model(camera);
    for (int v = 0; v <= rows; ++v) {
      for (int u = 0; u <= columns; ++u) {
        // Tiles may stick out of the image, where a lens need not see anything.
        const Eigen::Vector2d pixel(std::min(u, camera.width), std::min(v, camera.height));
        const auto ray = model.unproject(pixel - Eigen::Vector2d(0.5, 0.5));
        if (!ray) {
          throw std::invalid_argument("simulated camera: its lens sees nothing at pixel (" +
                                      std::to_string(u) + ", " + std::to_string(v) +
                                      "): take a smaller image or another distortion");
        }
        rays_.push_back(*ray);
      }
    }
  }

  /// Interpolated within a pixel, where a lens is as good as linear.
  Eigen::Vector2d within(int u, int v, const Eigen::Vector2d& part) const {
    const Eigen::Vector2d* upper = &rays_[static_cast<std::size_t>(v * columns_ + u)];
    const Eigen::Vector2d* lower = upper + columns_;
    const Eigen::Vector2d above = upper[0] + part.x() * (upper[1] - upper[0]);
    const Eigen::Vector2d below = lower[0] + part.x() * (lower[1] - lower[0]);
    return above + part.y() * (below - above);
  }

 private:
  int columns_;
  std::vector<Eigen::Vector2d> rays_;
};

Eigen::Vector2d onTorus(const Eigen::Vector2d& point) {
  return point - Eigen::Vector2d(point.array().floor());
}

}  // namespace

void RayBounds::extend(const RayBounds& other) {
  x_min = std::min(x_min, other.x_min);
  x_max = std::max(x_max, other.x_max);
  y_min = std::min(y_min, other.y_min);
  y_max = std::max(y_max, other.y_max);
}

CameraRays::CameraRays(const CameraCalibration& calibration, int samples)
    : samples_(samples),
      columns_((calibration.width + kTileEdge - 1) / kTileEdge),
      rows_((calibration.height + kTileEdge - 1) / kTileEdge) {
  if (samples < 1) throw std::invalid_argument("a camera needs at least one sample a pixel");
  const CornerRays corners(calibration, columns_ * kTileEdge, rows_ * kTileEdge);
  const auto pattern = samplePattern(samples);
  x_.resize(static_cast<std::size_t>(columns_ * rows_ * samples) * kTilePixels);
  y_.resize(x_.size());
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  bounds_.assign(static_cast<std::size_t>(columns_ * rows_),
                 {kInfinity, -kInfinity, kInfinity, -kInfinity});
  RandomStream random(kShiftSeed, 0);
  for (int v = 0; v < rows_ * kTileEdge; ++v) {
    for (int u = 0; u < columns_ * kTileEdge; ++u) {
      const int tile = v / kTileEdge * columns_ + u / kTileEdge;
      const int pixel = v % kTileEdge * kTileEdge + u % kTileEdge;
      const double shift_x = random.uniform();
      const Eigen::Vector2d shift(shift_x, random.uniform());
      for (int sample = 0; sample < samples; ++sample) {
        const auto place = onTorus(pattern[static_cast<std::size_t>(sample)] + shift);
        const Eigen::Vector2d ray = corners.within(u, v, place);
        const auto i = index(tile, sample) + static_cast<std::size_t>(pixel);
        x_[i] = static_cast<float>(ray.x());
        y_[i] = static_cast<float>(ray.y());
        bounds_[static_cast<std::size_t>(tile)].extend({x_[i], x_[i], y_[i], y_[i]});
      }
    }
  }
}

}  // namespace slam::sim
