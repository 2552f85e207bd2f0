// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/pcd_file.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include "slam_core/common/atomic_file.hpp"

namespace slam::point_map {
namespace {

constexpr const char* kHeader =
    "# .PCD v0.7 - Point Cloud Data file format\n"
    "VERSION 0.7\n"
    "FIELDS x y z intensity\n"
    "SIZE 4 4 4 4\n"
    "TYPE F F F F\n"
    "COUNT 1 1 1 1\n"
    "WIDTH {0}\n"
    "HEIGHT 1\n"
    "VIEWPOINT 0 0 0 1 0 0 0\n"
    "POINTS {0}\n"
    "DATA ascii\n";

}  // namespace

std::string toPcd(const std::vector<MapPoint>& points) {
  fmt::memory_buffer text;
  fmt::format_to(fmt::appender(text), fmt::runtime(kHeader), points.size());
  for (const auto& [position, count] : points)  // adding zero turns -0 into 0
    fmt::format_to(fmt::appender(text), FMT_COMPILE("{:.6f} {:.6f} 0 {}\n"), position.x() + 0.0,
                   position.y() + 0.0, count);
  return fmt::to_string(text);
}

void savePcd(const std::string& path, const std::vector<MapPoint>& points) {
  writeFileAtomically(path, toPcd(points));
}

}  // namespace slam::point_map
