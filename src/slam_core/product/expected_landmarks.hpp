// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/status.hpp"
#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// The landmarks that a product's detector finds, with which those of a loaded map are compared: a
/// map that another detector has made tells the robot nothing, and what it sees may be taken for
/// landmarks that are something else. Where observations come from outside, nothing is expected.
class ExpectedLandmarks {
 public:
  ExpectedLandmarks() = default;
  explicit ExpectedLandmarks(const ProductConfig& product);

  /// @return a warning where no point of the map can be one that the detector finds, by their
  /// descriptors; a map without points is not judged
  Status judge(const LandmarkMap& map) const;

 private:
  std::string detector_;  ///< its name; empty where nothing is known of it
  LandmarkTraits traits_;
};

}  // namespace slam
