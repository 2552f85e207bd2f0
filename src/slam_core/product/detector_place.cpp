// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/detector_place.hpp"

#include <algorithm>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/camera/camera_view.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/placed_detector.hpp"

namespace slam {
namespace {

/// Two detectors may find one family under two names, since OpenCV has the AprilTags as well.
/// @return the name that both have in common
std::string plainName(const std::string& family) {
  const std::string opencv = "DICT_APRILTAG_";
  return family.rfind(opencv, 0) == 0 ? family.substr(opencv.size()) : family;
}

constexpr const char* kNoDetector = "none";

void requireCamera(const std::string& name, LandmarkDetector& detector) {
  if (portsOf(detector).input(CameraConfig::kSection, kindOf<CameraView>()) == nullptr)
    throw ConfigError("second_camera: the detector '" + name +
                      "' does not look through the camera, so that it cannot look through a second "
                      "one; leave the key out, or choose a detector of markers");
}

}  // namespace

std::string DetectorPlace::prefix() const {
  return std::string(is_rear ? "rear_" : "") + (is_second ? "second_" : "");
}

std::vector<std::string> DetectorPlace::features() const {
  if (!is_rear) return {key()};
  if (is_second) return {"second_camera", "second_detector"};
  return {"second_camera"};
}

std::string DetectorPlace::description() const {
  return std::string("landmarks") + (is_second ? ", second detector" : "") +
         (is_rear ? ", rear camera" : "");
}

std::vector<DetectorPlace> detectorPlacesOf(const ProductConfig& product) {
  if (product.second_detector == product.detector && product.detector != kNoDetector)
    throw ConfigError("second_detector: '" + product.detector +
                      "' is the first detector already; name another one, or none");
  std::vector<DetectorPlace> places;
  for (const bool is_rear : {false, true}) {
    if (is_rear && !product.second_camera) break;
    for (const bool is_second : {false, true}) {
      const auto& name = is_second ? product.second_detector : product.detector;
      if (name != kNoDetector) places.push_back({name, is_second, is_rear});
    }
  }
  return places;
}

std::unique_ptr<LandmarkDetector> createDetector(const DetectorPlace& place) {
  std::unique_ptr<LandmarkDetector> detector;
  try {
    detector = Registry<LandmarkDetector>::instance().create(place.name);
  } catch (const ConfigError& error) {
    throw ConfigError(std::string(error.what()) + "; 'none' looks at no images");
  }
  if (place.is_second) detector->startIdsAt(DetectorPlace::kSecondIds);
  if (place.prefix().empty()) return detector;
  PlacedDetector::Names names{{"observations", place.observations()}};
  if (place.is_rear) {
    requireCamera(place.name, *detector);
    names[CameraConfig::kSection] = RearCameraConfig::kSection;
  }
  return std::make_unique<PlacedDetector>(std::move(detector), std::move(names));
}

void DetectorIds::add(const DetectorPlace& place, const LandmarkDetector& detector) {
  if (place.is_rear) return;  // the same landmarks as of the detector at the first camera
  for (auto& range : detector.ids()) entries_.push_back({place.name, std::move(range)});
}

void DetectorIds::requireUnique() const {
  FaultCollector faults;
  for (auto a = entries_.begin(); a != entries_.end(); ++a)
    for (auto b = a + 1; b != entries_.end(); ++b) {
      if (a->detector == b->detector) continue;
      if (plainName(a->range.family) == plainName(b->range.family))
        faults.add(b->detector + ": " + b->range.family + " holds the markers of " + a->detector +
                   "'s " + a->range.family +
                   ", which would count twice; leave it out of the list of one of the two");
      else if (a->range.overlaps(b->range))
        faults.add(b->detector + ".id_offsets: the ids of " + a->detector + "'s " +
                   a->range.text() + " and of " + b->detector + "'s " + b->range.text() +
                   " overlap, so that one could pass for the other; give " + b->range.family +
                   " an offset of " + std::to_string(a->range.last() + 1) + " or more");
    }
  faults.raise();
}

}  // namespace slam
