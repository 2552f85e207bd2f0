// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "slam_core/common/random.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

constexpr double kLampGray = 255.0;

/// The holes and fissures of an acoustic tile, no two tiles alike.
void drawSpeckles(cv::Mat tile, double gray, RandomStream& random) {
  const auto pick = [&random](int n) { return static_cast<int>(random.uniform() * n); };
  const int count = tile.cols * tile.cols / 160;
  for (int i = 0; i < count; ++i) {
    const cv::Point at(pick(tile.cols), pick(tile.rows));
    const double depth = 20.0 + 70.0 * random.uniform();
    if (pick(6) == 0) {
      cv::ellipse(tile, at, {2 + pick(7), 1 + pick(2)}, pick(180), 0, 360, gray - depth,
                  cv::FILLED);
    } else {
      cv::circle(tile, at, pick(3), gray - depth, cv::FILLED);
    }
  }
}

void drawLamp(cv::Mat tile, double frame_gray) {
  const int rim = tile.cols / 16;
  tile.setTo(frame_gray);
  cv::Mat panel = tile(cv::Rect(rim, rim, tile.cols - 2 * rim, tile.rows - 2 * rim));
  panel.setTo(kLampGray);
  for (int line = 1; line < 4; ++line) {  // the louvre
    panel.col(line * panel.cols / 4) -= 60.0;
    panel.row(line * panel.rows / 4) -= 60.0;
  }
}

/// A round ventilation outlet.
void drawOutlet(cv::Mat tile) {
  const cv::Point middle(tile.cols / 2, tile.rows / 2);
  for (int ring = 0; ring < 4; ++ring) {
    cv::circle(tile, middle, tile.cols * (8 - 2 * ring) / 20, ring % 2 == 0 ? 105.0 : 185.0,
               cv::FILLED);
  }
}

bool isLamp(int row, int column) {
  return row % kLampSpacing == kFirstLamp && column % kLampSpacing == kFirstLamp;
}

cv::Mat acousticTiles(int edge, std::uint64_t seed) {
  cv::Mat ceiling(edge, edge, CV_32F);
  const int size = edge / kCeilingTiles;
  RandomStream random(seed, 0);
  for (int row = 0; row < kCeilingTiles; ++row) {
    for (int column = 0; column < kCeilingTiles; ++column) {
      cv::Mat tile = ceiling(cv::Rect(column * size, row * size, size, size));
      const double gray = 158.0 + 14.0 * random.uniform();
      tile.setTo(gray);
      drawSpeckles(tile, gray, random);
      if (isLamp(row, column)) drawLamp(tile, 120.0);
      if (row % 4 == 3 && column % 8 == 5) drawOutlet(tile);
    }
  }
  const int bar = std::max(1, size / 32);
  for (int i = 0; i < kCeilingTiles; ++i) {
    ceiling.rowRange(i * size, i * size + bar).setTo(205.0);
    ceiling.colRange(i * size, i * size + bar).setTo(205.0);
    ceiling.row(i * size + bar).setTo(110.0);
    ceiling.col(i * size + bar).setTo(110.0);
  }
  return ceiling;
}

}  // namespace

cv::Mat ceilingTexture(const std::string& name, int edge, std::uint64_t seed) {
  cv::Mat ceiling;
  if (name == "tiles") {
    ceiling = acousticTiles(edge, seed);
  } else if (name == "plaster") {
    ceiling = 165.0 + 110.0 * fractalNoise(edge, kCeilingTiles, 7, seed);
  } else if (name == "plain") {
    ceiling = 175.0 + 4.0 * fractalNoise(edge, kCeilingTiles, 7, seed);
  } else {
    throw std::invalid_argument("no ceiling texture is called '" + name + "'");
  }
  cv::Mat gray;
  ceiling.convertTo(gray, CV_8U);
  return gray;
}

}  // namespace slam::sim
