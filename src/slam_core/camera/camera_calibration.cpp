// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "slam_core/common/nearest_name.hpp"
#include "slam_core/geometry/mount.hpp"

namespace slam {
namespace {

/// The numbers of coefficients each distortion model may come with.
const std::map<std::string, std::vector<std::size_t>> kDistortionModels = {
    {"plumb_bob", {0, 4, 5}}, {"rational_polynomial", {8}}, {"equidistant", {4}}};

/// Fisheyes have a focal length of a third of their image, telephoto lenses one of a hundred
/// images; a region of interest is a small part of its image. Beyond these shares of the longer
/// side are normalised units, and other numbers that are no pixels.
constexpr double kLeastShare = 0.01, kLargestShare = 1000.0;

std::string faultOfDistortion(const CameraCalibration& calibration) {
  const auto& name = calibration.distortion_model;
  const auto count = calibration.distortion.size();
  if (name.empty() && count == 0) return "";  // what simulators write who know no distortion
  const auto model = kDistortionModels.find(name);
  if (model == kDistortionModels.end()) {
    std::vector<std::string> names;
    for (const auto& entry : kDistortionModels) names.push_back(entry.first);
    return "its distortion model '" + name + "' is not known; there are: " + join(names) +
           didYouMean(name, names);
  }
  const auto& counts = model->second;
  if (std::count(counts.begin(), counts.end(), count) == 0)
    return "its distortion model " + name + " has " + std::to_string(count) +
           " coefficients instead of " + std::to_string(counts.back());
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(calibration.distortion.begin(), calibration.distortion.end(), finite))
    return "a distortion coefficient is not a number";
  return "";
}

}  // namespace

bool CameraCalibration::operator==(const CameraCalibration& other) const {
  return width == other.width && height == other.height && fx == other.fx && fy == other.fy &&
         cx == other.cx && cy == other.cy && distortion_model == other.distortion_model &&
         distortion == other.distortion;
}

std::string faultOf(const CameraCalibration& calibration) {
  const auto& c = calibration;
  if (c.width <= 0 || c.height <= 0) return "its image has no size";
  if (c.fx == 0.0 && c.fy == 0.0) return "its focal lengths are zero: the camera is not calibrated";
  if (!std::isfinite(c.fx) || !std::isfinite(c.fy) || c.fx <= 0.0 || c.fy <= 0.0)
    return "its focal lengths are not positive numbers";
  if (!std::isfinite(c.cx) || !std::isfinite(c.cy)) return "its principal point is not a number";
  const double side = std::max(c.width, c.height);
  const auto [shorter, longer] = std::minmax(c.fx, c.fy);
  if (shorter < kLeastShare * side || longer > kLargestShare * side)
    return fmt::format(
        "its focal lengths of {:g} and {:g} px fit no lens of an image of {} x {} px", c.fx, c.fy,
        c.width, c.height);
  if (std::max(std::abs(c.cx), std::abs(c.cy)) > kLargestShare * side)
    return fmt::format("its principal point is at ({:g}, {:g}) px, far from an image of {} x {} px",
                       c.cx, c.cy, c.width, c.height);
  return faultOfDistortion(c);
}

std::string faultOf(const CameraMount& mount) { return faultOfMount(mount.T_base_camera); }

}  // namespace slam
