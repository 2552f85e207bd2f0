// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "texture_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace slam::sim {
namespace {

constexpr double kTexelsPerPixel = 2.0;      // along the direction in which they are largest
constexpr double kMostTexelsPerPixel = 8.0;  // where a plane is seen at a slant

/// Texels a pixel [largest, smallest], the singular values of the mapping.
std::pair<double, double> texelsPerPixel(const Eigen::Matrix2d& J) {
  const double sum = J.squaredNorm() / 2.0, det = J.determinant();
  const double root = std::sqrt(std::max(sum * sum - det * det, 0.0));
  return {std::sqrt(sum + root), std::sqrt(std::max(sum - root, 0.0))};
}

}  // namespace

TextureView viewTexture(const Surface& surface, const PlaneView& view, std::size_t level) {
  const double shrink = std::ldexp(1.0, -static_cast<int>(level));
  const Texture::Level& texels = surface.texture->levels()[level];
  const auto scale = static_cast<float>(surface.texels_per_metre * shrink);
  const Eigen::Vector2f start =
      (surface.texture_origin * shrink).cast<float>().array() + texels.offset;
  return {&texels, view.w, view.uw * scale + view.w * start.x(),
          view.vw * scale + view.w * start.y()};
}

std::size_t levelFor(const Surface& surface, const PlaneView& view, float ray_x, float ray_y,
                     const Eigen::Vector2d& ray_step) {
  const double w = std::max(view.w.at(ray_x, ray_y), 1e-3F);
  const double u = view.uw.at(ray_x, ray_y) / w, v = view.vw.at(ray_x, ray_y) / w;
  Eigen::Matrix2d J;
  J << view.uw.x - u * view.w.x, view.uw.y - u * view.w.y,  //
      view.vw.x - v * view.w.x, view.vw.y - v * view.w.y;
  J *= surface.texels_per_metre / w * ray_step.asDiagonal();
  const auto [most, least] = texelsPerPixel(J);
  const double shrink = std::max(least / kTexelsPerPixel, most / kMostTexelsPerPixel);
  const long level = shrink > 1.0 ? std::lround(std::log2(shrink)) : 0;
  return std::min(static_cast<std::size_t>(level), surface.texture->levels().size() - 1);
}

void sampleTexture(const TextureView& view, const float* x, const float* y, int n, float* gray) {
  float part_u[CameraRays::kTilePixels], part_v[CameraRays::kTilePixels];
  std::int32_t place[CameraRays::kTilePixels];
  std::uint32_t texels[CameraRays::kTilePixels];
  const Texture::Level& level = *view.level;
  const LinearForm w = view.w, uw = view.uw, vw = view.vw;
  const int mask_u = level.mask_u, mask_v = level.mask_v, stride = level.stride;
  for (int i = 0; i < n; ++i) {
    const float depth = 1.0F / (w.x * x[i] + w.y * y[i] + w.c);
    // Rounding may put a ray beyond the edge by a hair; the rim of the texture is wider.
    const float u = (uw.x * x[i] + uw.y * y[i] + uw.c) * depth;
    const float v = (vw.x * x[i] + vw.y * y[i] + vw.c) * depth;
    const auto whole_u = static_cast<std::int32_t>(u), whole_v = static_cast<std::int32_t>(v);
    part_u[i] = u - static_cast<float>(whole_u);
    part_v[i] = v - static_cast<float>(whole_v);
    place[i] = (whole_v & mask_v) * stride + (whole_u & mask_u);
  }
  const std::uint8_t* first = level.texels.data();
  for (int i = 0; i < n; ++i) {
    std::uint16_t upper, lower;
    std::memcpy(&upper, first + place[i], sizeof upper);
    std::memcpy(&lower, first + place[i] + stride, sizeof lower);
    texels[i] = static_cast<std::uint32_t>(lower) << 16 | upper;
  }
  for (int i = 0; i < n; ++i) {
    const auto byte = [&](int k) {
      return static_cast<float>(static_cast<std::int32_t>(texels[i] >> (8 * k) & 255U));
    };
    const float above = byte(0) + part_u[i] * (byte(1) - byte(0));
    const float below = byte(2) + part_u[i] * (byte(3) - byte(2));
    gray[i] = above + part_v[i] * (below - above);
  }
}

}  // namespace slam::sim
