// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_calibration.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "slam_core/camera/camera_model.hpp"
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
/// The principal point of a whole image is in it, or beyond its border by this share at most.
constexpr double kBeyond = 0.25;

/// Half-way to the nearest border an ideal lens sees a direction by this factor more or less far
/// from the axis than one with distortion, at most. Wide lenses reach 1.2 there.
constexpr double kMostBent = 3.0;

/// Coefficients of another scale, or of another model, bend the image beyond that, or fold it.
bool bendsAsNoLens(const CameraCalibration& calibration) {
  const CameraModel camera(calibration);
  const double way = std::min(calibration.width, calibration.height) / 4.0;
  const std::array<Eigen::Vector2d, 4> ways{{{way, 0.0}, {-way, 0.0}, {0.0, way}, {0.0, -way}}};
  return !std::all_of(ways.begin(), ways.end(), [&](const Eigen::Vector2d& from_centre) {
    const auto seen =
        camera.unproject(from_centre + Eigen::Vector2d(calibration.cx, calibration.cy));
    if (!seen) return false;
    const double radius =
        Eigen::Vector2d(from_centre.x() / calibration.fx, from_centre.y() / calibration.fy).norm();
    const double straight =
        calibration.distortion_model == "equidistant" ? radius : std::atan(radius);
    const double bent = std::atan(seen->norm());
    return bent < kMostBent * straight && straight < kMostBent * bent;
  });
}

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
  if (count > 0 && bendsAsNoLens(calibration))
    return "its distortion coefficients bend the image as no lens does";
  return "";
}

}  // namespace

bool CameraCalibration::operator==(const CameraCalibration& other) const {
  return width == other.width && height == other.height && fx == other.fx && fy == other.fy &&
         cx == other.cx && cy == other.cy && distortion_model == other.distortion_model &&
         distortion == other.distortion && is_region == other.is_region;
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
  const double beyond = c.is_region ? kLargestShare * side : kBeyond * side;
  if (std::max(-c.cx, c.cx - c.width) > beyond || std::max(-c.cy, c.cy - c.height) > beyond)
    return fmt::format("its principal point is at ({:g}, {:g}) px, far from an image of {} x {} px",
                       c.cx, c.cy, c.width, c.height);
  return faultOfDistortion(c);
}

std::string faultOf(const CameraMount& mount) { return faultOfMount(mount.T_base_camera); }

}  // namespace slam
