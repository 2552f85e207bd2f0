// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace slam::sim {

/// Procedural textures of an indoor world: square, 8 bit, seamless when repeated, the same for the
/// same arguments. Their edges are powers of two [texels].

/// Sum of `octaves` of value noise (Perlin, An image synthesizer, SIGGRAPH 1985), the coarsest with
/// `cells` cells along an edge, each further one twice as fine and half as strong. CV_32F, about
/// within [-1, 1].
cv::Mat fractalNoise(int edge, int cells, int octaves, std::uint64_t seed);

cv::Mat plasterTexture(int edge, std::uint64_t seed);    ///< a painted wall: bright, low contrast
cv::Mat wallpaperTexture(int edge, std::uint64_t seed);  ///< faint stripes with a small motif
cv::Mat floorTexture(int edge, std::uint64_t seed);      ///< speckled linoleum in sheets
cv::Mat woodTexture(int edge, std::uint64_t seed);       ///< grain along v

// With features from near and from afar; band-limited to their texels.
cv::Mat brickTexture(int edge, std::uint64_t seed);       ///< 16 courses of 8 bricks
cv::Mat panellingTexture(int edge, std::uint64_t seed);   ///< 8 upright boards
cv::Mat tiledFloorTexture(int edge, std::uint64_t seed);  ///< 4 x 4 tiles, as on a chessboard
cv::Mat parquetTexture(int edge, std::uint64_t seed);     ///< 16 rows of planks along u
cv::Mat terrazzoTexture(int edge, std::uint64_t seed);    ///< splinters of all sizes
cv::Mat booksTexture(int edge, std::uint64_t seed);       ///< three shelves of spines

/// A ceiling, kCeilingTiles tiles along an edge of the texture. Its bright parts are lamps.
/// @param name one of ceilingTextures()
cv::Mat ceilingTexture(const std::string& name, int edge, std::uint64_t seed);

constexpr int kCeilingTiles = 8;
/// Every so many tiles, in both directions, one is a lamp, kFirstLamp the first [tiles].
constexpr int kLampSpacing = 4;
constexpr int kFirstLamp = 1;

}  // namespace slam::sim
