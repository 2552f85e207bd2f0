// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slam::grid_map {

/// An image of 8 bit grey values, row by row from the top.
struct PgmImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// A binary PGM file (P5) with one line of comment.
std::string toPgm(const PgmImage& image, const std::string& comment);

/// @throw std::runtime_error with what is wrong with the file's content
PgmImage fromPgm(const std::string& content);

}  // namespace slam::grid_map
