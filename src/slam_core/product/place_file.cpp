// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/place_file.hpp"

#include <fmt/format.h>

namespace slam {
namespace {

std::string secondsText(Stamp stamp) {
  return fmt::format("{}.{:09d}", nanoseconds(stamp) / 1000000000, nanoseconds(stamp) % 1000000000);
}

}  // namespace

std::string placeTable(const std::vector<PlaceVisit>& visits) {
  std::string table = "stamp,first_visit\n";
  for (const auto& [stamp, first] : visits)
    table += secondsText(stamp) + "," + (first ? secondsText(*first) : "") + "\n";
  return table;
}

}  // namespace slam
