// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/texture.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace slam::sim {
namespace {

bool isPowerOfTwo(int n) { return n > 0 && (n & (n - 1)) == 0; }

Texture::Level makeLevel(const cv::Mat& exact, Texture::Wrap wrap) {
  const bool repeat = wrap == Texture::Wrap::kRepeat;
  cv::Mat gray;
  exact.convertTo(gray, CV_8U);
  cv::Mat rimmed;
  cv::copyMakeBorder(gray, rimmed, repeat ? 0 : 1, 1, repeat ? 0 : 1, 1,
                     repeat ? cv::BORDER_WRAP : cv::BORDER_REPLICATE);
  Texture::Level level;
  level.texels.assign(rimmed.begin<std::uint8_t>(), rimmed.end<std::uint8_t>());
  level.stride = rimmed.cols;
  if (repeat) {
    level.mask_u = gray.cols - 1;
    level.mask_v = gray.rows - 1;
    // A period more, so that nothing inside a surface is negative.
    level.offset = static_cast<float>(std::max(gray.cols, gray.rows)) - 0.5F;
  } else {
    level.offset = 0.5F;
  }
  return level;
}

cv::Mat halved(const cv::Mat& exact) {
  cv::Mat even, small;
  cv::copyMakeBorder(exact, even, 0, exact.rows % 2, 0, exact.cols % 2, cv::BORDER_REPLICATE);
  cv::resize(even, small, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  return small;
}

}  // namespace

Texture::Texture(const cv::Mat& gray, Wrap wrap) {
  if (gray.empty() || gray.type() != CV_8UC1) {
    throw std::invalid_argument("a texture needs a gray image of 8 bit");
  }
  if (wrap == Wrap::kRepeat && (!isPowerOfTwo(gray.cols) || !isPowerOfTwo(gray.rows))) {
    throw std::invalid_argument("a texture that repeats needs edges that are powers of two");
  }
  mean_ = cv::mean(gray)[0];
  constexpr int kSmallest = 4;  // [texels]
  cv::Mat level;
  for (gray.convertTo(level, CV_32F);; level = halved(level)) {
    levels_.push_back(makeLevel(level, wrap));
    if (std::min(level.cols, level.rows) <= kSmallest) break;
  }
}

}  // namespace slam::sim
