// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/camera_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <utility>

#include "pixel_noise.hpp"
#include "tile_renderer.hpp"

namespace slam::sim {
namespace {

constexpr double kFullWhite = 235.0;  // gray value of a white surface in full light
constexpr int kTile = CameraRays::kTileEdge;
constexpr int kBlock = 4;  // surfaces are looked up for blocks of so many tiles squared first

void checkOptics(const CameraOptics& optics) {
  const bool fine = optics.exposure >= 0.0 && optics.rolling_shutter >= 0.0 &&
                    optics.brightness >= 0.0 && optics.vignetting >= 0.0 &&
                    optics.vignetting <= 1.0 && optics.defocus_sigma >= 0.0 &&
                    optics.noise_sigma >= 0.0 && optics.samples >= 1;
  if (!fine) {
    throw std::invalid_argument(
        "camera optics: exposure, rolling shutter, brightness, defocus and noise must not be "
        "negative, vignetting "
        "must lie within [0, 1], samples must be at least 1");
  }
}

CameraCalibration checked(const CameraCalibration& calibration) {
  const std::string fault = faultOf(calibration);
  if (!fault.empty()) throw std::invalid_argument("simulated camera: " + fault);
  return calibration;
}

/// From light to gray values; vignetting grows with the square of the distance from the middle.
cv::Mat gainOf(const CameraCalibration& camera, const CameraOptics& optics) {
  cv::Mat gain(camera.height, camera.width, CV_32F);
  const double half_diagonal = std::hypot(camera.width, camera.height) / 2.0;
  for (int v = 0; v < gain.rows; ++v) {
    for (int u = 0; u < gain.cols; ++u) {
      const double r = std::hypot(u - camera.cx, v - camera.cy) / half_diagonal;
      const double lost = std::min(optics.vignetting * r * r, 1.0);
      gain.at<float>(v, u) = static_cast<float>(kFullWhite * optics.brightness * (1.0 - lost));
    }
  }
  return gain;
}

RayBounds boundsOf(const CameraRays& rays, int first_row, int last_row, int first_column,
                   int last_column) {
  RayBounds bounds = rays.bounds(first_row * rays.columns() + first_column);
  for (int row = first_row; row < last_row; ++row) {
    for (int column = first_column; column < last_column; ++column) {
      bounds.extend(rays.bounds(row * rays.columns() + column));
    }
  }
  return bounds;
}

}  // namespace

CameraRenderer::CameraRenderer(std::shared_ptr<const Scene> scene,
                               const CameraCalibration& calibration, const CameraOptics& optics)
    : scene_(std::move(scene)),
      calibration_(checked(calibration)),
      optics_(optics),
      rays_(calibration, optics.samples),
      gain_(gainOf(calibration, optics)) {
  checkOptics(optics);
}

cv::Mat CameraRenderer::render(const CameraPath& T_world_camera, RandomStream noise,
                               double light_level) const {
  cv::Mat gray(calibration_.height, calibration_.width, CV_32F);
  // The rows of a tile are exposed together, those of a global shutter all.
  const int band = optics_.rolling_shutter > 0.0 ? 1 : rays_.rows();
  for (int row = 0; row < rays_.rows(); row += band) {
    std::vector<Eigen::Isometry3d> poses;
    for (int sample = 0; sample < optics_.samples; ++sample) {
      poses.push_back(T_world_camera(partOf((sample + 0.5) / optics_.samples, row)));
    }
    const auto bounds = boundsOf(rays_, row, row + band, 0, rays_.columns());
    renderBand(row, row + band, viewedSurfaces(scene_->surfaces(), poses, bounds), gray);
  }
  cv::multiply(gray, gain_, gray, light_level);
  if (optics_.defocus_sigma > 0.0) {
    cv::GaussianBlur(gray, gray, cv::Size(), optics_.defocus_sigma, 0.0, cv::BORDER_REPLICATE);
  }
  return withPixelNoise(gray, optics_.noise_sigma, noise);
}

double CameraRenderer::partOf(double of_exposure, int tile_row) const {
  if (optics_.rolling_shutter <= 0.0) return of_exposure;
  const double down = std::min((tile_row + 0.5) * kTile / calibration_.height, 1.0);
  return (of_exposure * optics_.exposure + down * optics_.rolling_shutter) /
         (optics_.exposure + optics_.rolling_shutter);
}

void CameraRenderer::renderBand(int first_row, int end_row,
                                const std::vector<ViewedSurface>& viewed, cv::Mat& light) const {
  const Eigen::Vector2d ray_step(1.0 / calibration_.fx, 1.0 / calibration_.fy);
  TileRenderer renderer(rays_, ray_step);
  std::vector<const ViewedSurface*> in_block, in_tile;
  for (int block_row = first_row; block_row < end_row; block_row += kBlock) {
    for (int block_column = 0; block_column < rays_.columns(); block_column += kBlock) {
      const int last_row = std::min(block_row + kBlock, end_row);
      const int last_column = std::min(block_column + kBlock, rays_.columns());
      const auto bounds = boundsOf(rays_, block_row, last_row, block_column, last_column);
      in_block.clear();
      for (const auto& surface : viewed) {
        if (surface.mayBeMetBy(bounds)) in_block.push_back(&surface);
      }
      for (int row = block_row; row < last_row; ++row) {
        for (int column = block_column; column < last_column; ++column) {
          const int tile = row * rays_.columns() + column;
          in_tile.clear();
          for (const auto* surface : in_block) {
            if (surface->mayBeMetBy(rays_.bounds(tile))) in_tile.push_back(surface);
          }
          writeTile(tile, renderer.render(tile, in_tile), light);
        }
      }
    }
  }
}

void CameraRenderer::writeTile(int tile, const TileValues& values, cv::Mat& light) const {
  const int first_row = tile / rays_.columns() * kTile,
            first_column = tile % rays_.columns() * kTile;
  const int columns = std::min(kTile, light.cols - first_column);
  for (int row = 0; row < std::min(kTile, light.rows - first_row); ++row) {
    std::copy_n(values.begin() + row * kTile, columns,
                light.ptr<float>(first_row + row) + first_column);
  }
}

}  // namespace slam::sim
