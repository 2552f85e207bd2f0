// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/marker_family.hpp"

#include <algorithm>

namespace slam::sim {

const std::vector<MarkerFamily>& markerFamilies() {
  static const std::vector<MarkerFamily> kFamilies = {{"36h11", 587},
                                                      {"25h9", 35},
                                                      {"16h5", 30},
                                                      {"Standard41h12", 2115},
                                                      {"DICT_4X4_50", 50},
                                                      {"DICT_4X4_100", 100},
                                                      {"DICT_4X4_250", 250},
                                                      {"DICT_4X4_1000", 1000},
                                                      {"DICT_5X5_50", 50},
                                                      {"DICT_5X5_100", 100},
                                                      {"DICT_5X5_250", 250},
                                                      {"DICT_5X5_1000", 1000},
                                                      {"DICT_6X6_50", 50},
                                                      {"DICT_6X6_100", 100},
                                                      {"DICT_6X6_250", 250},
                                                      {"DICT_6X6_1000", 1000},
                                                      {"DICT_7X7_50", 50},
                                                      {"DICT_7X7_100", 100},
                                                      {"DICT_7X7_250", 250},
                                                      {"DICT_7X7_1000", 1000},
                                                      {"DICT_ARUCO_ORIGINAL", 1024},
                                                      {"DICT_APRILTAG_16h5", 30},
                                                      {"DICT_APRILTAG_25h9", 35},
                                                      {"DICT_APRILTAG_36h10", 2320},
                                                      {"DICT_APRILTAG_36h11", 587}};
  return kFamilies;
}

std::vector<std::string> markerFamilyNames() {
  std::vector<std::string> names;
  for (const auto& family : markerFamilies()) names.push_back(family.name);
  return names;
}

const MarkerFamily* findMarkerFamily(const std::string& name) {
  const auto& all = markerFamilies();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const MarkerFamily& family) { return family.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace slam::sim
