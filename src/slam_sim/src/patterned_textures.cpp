// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "dead_leaves.hpp"
#include "slam_core/common/random.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

constexpr double kSoftness = 0.7;  // standard deviation of the blur that limits the band [texels]

/// Returns the values as grays of 8 bit; what is finer than a texel is blurred.
cv::Mat finished(const cv::Mat& values) {
  const int rim = 4;
  cv::Mat wide, gray;
  cv::copyMakeBorder(values, wide, rim, rim, rim, rim, cv::BORDER_WRAP);
  cv::GaussianBlur(wide, wide, cv::Size(), kSoftness);
  wide(cv::Rect(rim, rim, values.cols, values.rows)).convertTo(gray, CV_8U);
  return gray;
}

/// Fills a rectangle that may stick out to the right, where it goes on at the left.
void fillWrapped(cv::Mat& canvas, const cv::Rect& place, double gray) {
  const cv::Rect all({0, 0}, canvas.size());
  for (const int shift : {0, -canvas.cols}) {
    const cv::Rect part = (place + cv::Point(shift, 0)) & all;
    if (part.area() > 0) canvas(part).setTo(gray);
  }
}

/// Lines of the grain along u.
cv::Mat grainAlongU(int edge, std::uint64_t seed) {
  cv::Mat fine = fractalNoise(edge, 128, 3, seed), grain;
  cv::Mat wide;
  cv::copyMakeBorder(fine, wide, 0, 0, edge / 2, edge / 2, cv::BORDER_WRAP);
  cv::blur(wide, wide, cv::Size(edge / 16 + 1, 1));
  wide(cv::Rect(edge / 2, 0, edge, edge)).copyTo(grain);
  return grain;
}

/// Rows of pieces, each of a tone of its own, with dark or bright joints.
struct Courses {
  int rows, pieces;           ///< in a period
  double shift;               ///< from row to row [pieces]; negative: at random
  double tone, tones, joint;  ///< middle and range of the tones, tone of the joints
  int joint_texels;
};

cv::Mat laid(int edge, const Courses& courses, std::uint64_t seed) {
  cv::Mat canvas(edge, edge, CV_32F, cv::Scalar(courses.joint));
  RandomStream random(seed, 0);
  const int height = edge / courses.rows, width = edge / courses.pieces;
  for (int row = 0; row < courses.rows; ++row) {
    const double by = courses.shift < 0.0 ? random.uniform() : row * courses.shift;
    const int first = static_cast<int>(by * width) % width;
    for (int piece = 0; piece < courses.pieces; ++piece) {
      const double tone = courses.tone + courses.tones * (random.uniform() - 0.5);
      fillWrapped(canvas,
                  {first + piece * width, row * height, width - courses.joint_texels,
                   height - courses.joint_texels},
                  tone);
    }
  }
  return canvas;
}

}  // namespace

cv::Mat brickTexture(int edge, std::uint64_t seed) {
  const Courses bricks{16, 8, 0.5, 120.0, 70.0, 190.0, edge / 128};
  return finished(laid(edge, bricks, seed) + 25.0 * fractalNoise(edge, 32, 5, seed + 1));
}

cv::Mat panellingTexture(int edge, std::uint64_t seed) {
  const Courses boards{8, 1, 0.0, 150.0, 60.0, 60.0, edge / 170};
  cv::Mat upright = laid(edge, boards, seed) + 160.0 * grainAlongU(edge, seed + 1);
  cv::rotate(upright, upright, cv::ROTATE_90_CLOCKWISE);
  return finished(upright);
}

cv::Mat tiledFloorTexture(int edge, std::uint64_t seed) {
  const Courses tiles{4, 4, 0.0, 0.0, 0.0, 70.0, edge / 128};
  cv::Mat floor = laid(edge, tiles, seed);
  const int size = edge / 4;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const cv::Rect tile(column * size, row * size, size - edge / 128, size - edge / 128);
      floor(tile).setTo((row + column) % 2 == 0 ? 110.0 : 195.0);
    }
  }
  // All tiles are cut from one mould: the same veins in each.
  cv::Mat vein = fractalNoise(size, 4, 4, seed + 1), veins;
  cv::repeat(vein, 4, 4, veins);
  return finished(floor + 40.0 * veins);
}

cv::Mat parquetTexture(int edge, std::uint64_t seed) {
  const Courses planks{16, 2, -1.0, 150.0, 70.0, 60.0, edge / 256};
  return finished(laid(edge, planks, seed) + 120.0 * grainAlongU(edge, seed + 1));
}

cv::Mat terrazzoTexture(int edge, std::uint64_t seed) {
  return finished(deadLeaves({edge, edge}, {1.5, edge / 24.0, 70.0, 230.0}, seed));
}

cv::Mat booksTexture(int edge, std::uint64_t seed) {
  constexpr int kBoards = 3;
  cv::Mat shelf(edge, edge, CV_32F, cv::Scalar(60.0));
  RandomStream random(seed, 0);
  const int height = edge / kBoards, board = edge / 48;
  for (int row = 0; row < kBoards; ++row) {
    int at = 0;
    while (at < edge) {
      const int width = edge / 64 + static_cast<int>(random.uniform() * edge / 28);
      const int tall = static_cast<int>((0.6 + 0.35 * random.uniform()) * (height - board));
      const cv::Rect spine(at, (row + 1) * height - board - tall, width, tall);
      fillWrapped(shelf, spine, 40.0 + 200.0 * random.uniform());
      // A title's bands.
      const int band = std::max(2, tall / 14), from = tall / 6;
      for (int line = 0; line < 2; ++line) {
        fillWrapped(shelf, {at, spine.y + from + 2 * line * band, width, band},
                    40.0 + 200.0 * random.uniform());
      }
      at += width;
    }
    shelf.rowRange((row + 1) * height - board, (row + 1) * height).setTo(170.0);
  }
  return finished(shelf + 6.0 * fractalNoise(edge, 64, 4, seed + 1));
}

}  // namespace slam::sim
