// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/time.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam {

/// A landmarks.yaml: format version, frame, units, means, 2x2 marginals, the pose, and the joint
/// covariance where the back-end has one.
struct LandmarkFile {
  static constexpr int kVersion = 1;

  std::string frame = "map";
  Stamp stamp;  ///< of the last update
  MapState map;
};

std::string toYaml(const LandmarkFile& file);

/// Written whole or not at all. @throw std::runtime_error naming the file and the cause, also where
/// the map holds what is no finite number
void saveLandmarks(const std::string& path, const LandmarkFile& file);

/// @param frame the map frame it must be in
/// @throw std::runtime_error in one sentence: missing, not YAML, another version or frame, a field
/// that is missing or not a number, an id used twice, a covariance that is none
LandmarkFile loadLandmarks(const std::string& path, const std::string& frame);

}  // namespace slam
