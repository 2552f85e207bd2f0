// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/place_file.hpp"

#include "slam_core/product/stamp_text.hpp"

namespace slam {

std::string placeTable(const std::vector<PlaceVisit>& visits) {
  std::string table = "stamp,first_visit\n";
  for (const auto& [stamp, first] : visits)
    table += stampText(stamp) + "," + (first ? stampText(*first) : "") + "\n";
  return table;
}

}  // namespace slam
