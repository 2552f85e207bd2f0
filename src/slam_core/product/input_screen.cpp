// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/input_screen.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

bool isInvalid(const LaserBeam& beam) {
  return !std::isfinite(beam.bearing) || !std::isfinite(beam.range) || beam.range <= 0.0f;
}

bool isValid(const LaserFan& fan) {
  return fan.sensor_pose.isFinite() && std::none_of(fan.beams.begin(), fan.beams.end(), isInvalid);
}

}  // namespace

std::optional<HeldDatum> InputScreen::pass(const InputPort& port, const void* value) {
  if (!isFit(port, value)) return std::nullopt;
  auto held = port.traits.hold(value);
  if (port.kind == kindOf<LandmarkObservationArray>()) {
    auto& array = *static_cast<LandmarkObservationArray*>(held.value.get());
    tell(observations_.screen(array, counters_));
    held.stamp = array.stamp;
  } else if (port.kind == kindOf<LaserScan>()) {
    screen(*static_cast<LaserScan*>(held.value.get()));
  }
  return held;
}

bool InputScreen::isFit(const InputPort& port, const void* value) {
  const auto fault = port.traits.fault_of(value);
  if (fault.empty()) return true;
  counters_.add("invalid_" + port.name);
  fault_ = fault + "; it is left out";
  return false;
}

void InputScreen::admit(const InputPort& port, void* value) {
  if (port.kind == kindOf<LandmarkObservationArray>())
    tell(observations_.admit(*static_cast<LandmarkObservationArray*>(value), counters_));
}

void InputScreen::tell(const std::string& sentence) {
  if (!sentence.empty()) fault_ = sentence;
}

void InputScreen::screen(LaserScan& scan) {
  bool is_valid = true;
  forEachFan(scan, [&](const LaserFan& fan) { is_valid = is_valid && isValid(fan); });
  if (is_valid) return;
  counters_.add("invalid_scan");
  fault_ =
      "a scan whose sensor pose or beams hold values that are not numbers, or a range that is not "
      "above 0, is taken as empty";
  scan.beams.clear();
  scan.further.clear();
}

void InputScreen::reset() {
  fault_.clear();
  counters_.clear();
}

}  // namespace slam
