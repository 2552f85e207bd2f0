// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/expected_landmarks.hpp"

#include <algorithm>

#include "slam_core/contract/registry.hpp"

namespace slam {

/// The detector may run in another process, whose libraries are not loaded here.
ExpectedLandmarks::ExpectedLandmarks(const ProductConfig& product) {
  const auto& registry = Registry<LandmarkDetector>::instance();
  const auto names = registry.names();
  if (std::find(names.begin(), names.end(), product.detector) == names.end()) return;
  detector_ = product.detector;
  traits_ = registry.create(detector_)->traits();
}

Status ExpectedLandmarks::judge(const LandmarkMap& map) const {
  const auto points = pointsOf(map);
  if (detector_.empty() || points.empty()) return Status::ok();
  const auto fits = [this](const Landmark& point) {
    return point.descriptor.isEmpty() != traits_.has_descriptor;
  };
  if (std::any_of(points.begin(), points.end(), fits)) return Status::ok();
  const std::string found =
      traits_.has_descriptor ? "no landmark of the loaded map has a descriptor, and each that "
                             : "all landmarks of the loaded map have a descriptor, and none that ";
  return Status::warning(found + "the detector '" + detector_ +
                         "' finds: if another detector has made the map, load a map of this one, "
                         "or choose the product's detector and association as they were then");
}

}  // namespace slam
