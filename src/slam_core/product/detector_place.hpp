// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// One of the detectors of a product: the first one at the first camera, the second one beside it,
/// and each of them at the rear camera. The ports of all but the first have names of their own,
/// from which their topics, counters and diagnostics follow.
struct DetectorPlace {
  /// The ids of a second detector begin here, unless its id_offsets say otherwise. No family has so
  /// many markers, so that AprilTag 3 is not ArUco 3.
  static constexpr LandmarkId kSecondIds = 10000;

  std::string name;  ///< of the detector, in the registry
  bool is_second = false;
  bool is_rear = false;

  /// "", "second_", "rear_", "rear_second_": what the names of its ports begin with.
  std::string prefix() const;
  /// "detector", "rear_second_detector": the prefix of its counters in a whole product.
  std::string key() const { return prefix() + "detector"; }
  /// The product's keys that bring it.
  std::vector<std::string> features() const;
  /// The name of its output.
  std::string observations() const { return prefix() + "observations"; }
  /// "landmarks, second detector, rear camera", for sentences
  std::string description() const;
};

/// The detectors that a product names, the first one first. One that is called none is not there.
/// @throw ConfigError where it names one twice
std::vector<DetectorPlace> detectorPlacesOf(const ProductConfig& product);

/// Creates the detector of a place: its ports have the names of the place, and its ids begin where
/// they are to. @throw ConfigError naming the detectors that there are, and where one has no camera
/// to exchange for the rear one
std::unique_ptr<LandmarkDetector> createDetector(const DetectorPlace& place);

/// Detectors of several kinds, to be asked once all are configured.
class DetectorIds {
 public:
  /// The place's ids; those of one detector at two cameras are the same landmarks.
  void add(const DetectorPlace& place, const LandmarkDetector& detector);
  /// @throw ConfigError where an id could be a landmark of two detectors, or a marker would be two
  /// landmarks
  void requireUnique() const;

 private:
  struct Entry {
    std::string detector;
    IdRange range;
  };
  std::vector<Entry> entries_;
};

}  // namespace slam
