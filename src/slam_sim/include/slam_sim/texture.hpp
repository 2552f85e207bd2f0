// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace slam::sim {

/// A gray texture with its levels of detail: each has half the resolution of the one before, every
/// texel the mean of those it covers (Williams, Pyramidal parametrics, SIGGRAPH 1983). Texel (i, j)
/// covers [i, i + 1) x [j, j + 1); u runs along the rows.
class Texture {
 public:
  enum class Wrap { kRepeat, kClamp };

  /// One level as the sampling loop wants it: stored with a rim, so that the texel to the right and
  /// below needs no test.
  struct Level {
    std::vector<std::uint8_t> texels;
    int stride = 0;
    int mask_u = -1, mask_v = -1;  ///< to be applied to the stored index
    float offset = 0.0F;           ///< texture coordinate to stored coordinate of texel centres
  };

  /// @param gray 8 bit, one channel; to repeat, its edges must be powers of two
  Texture(const cv::Mat& gray, Wrap wrap);

  const std::vector<Level>& levels() const { return levels_; }
  double mean() const { return mean_; }  ///< of all texels [0, 255]

 private:
  std::vector<Level> levels_;
  double mean_ = 0.0;
};

}  // namespace slam::sim
