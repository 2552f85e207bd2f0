// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slam::sim {

/// What is to be printed.
struct MarkerSheets {
  std::string family;             ///< see markerFamilies()
  std::vector<std::int64_t> ids;  ///< in the order of the sheets
  double size = 0.16;             ///< edge of the black square that a detector returns [m]
  std::string paper = "A4";       ///< see paperNames(); upper and lower case are the same
};

std::vector<std::string> paperNames();

/// "0-11,20" as numbers. @throw std::invalid_argument where it is none, or more than 10 000 ids
std::vector<std::int64_t> readIds(const std::string& text);

/// As many markers a page as fit, upright, each with its white margin, a line that cuts it out, and
/// a caption with family, id and size; at the foot of each page a ruler of 100 mm that shows
/// whether the printer has scaled it. The margin is two cells wide, or one where two do not fit.
struct PrintedSheets {
  std::string pdf;  ///< the file's content, in vectors
  int pages = 0;
  int markers_on_page = 0;  ///< at most
  bool has_narrow_margin = false;
};

/// @throw std::invalid_argument for an unknown family, id or paper, no id, and a size that is none
/// or that the paper has no room for
PrintedSheets printed(const MarkerSheets& sheets);

}  // namespace slam::sim
