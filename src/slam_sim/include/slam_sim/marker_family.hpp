// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slam::sim {

/// A set of markers that can be printed: an AprilTag family ("36h11", "25h9", "16h5",
/// "Standard41h12") or a predefined dictionary of OpenCV ("DICT_4X4_50", ...).
struct MarkerFamily {
  std::string name;
  std::int64_t ids;  ///< its ids are 0 to ids - 1
};

const std::vector<MarkerFamily>& markerFamilies();
std::vector<std::string> markerFamilyNames();

/// nullptr where there is none of that name.
const MarkerFamily* findMarkerFamily(const std::string& name);

}  // namespace slam::sim
