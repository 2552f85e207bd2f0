// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser/laser_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/mount.hpp"

namespace slam {
namespace {

/// Drivers count their last angle in or out.
constexpr double kBeamsOff = 1.5;

bool isUpsideDown(const LaserMount& mount) { return mount.T_base_laser.linear()(2, 2) < 0.0; }

/// Whether a beam with this range says nothing of what is there.
bool tellsNothing(float range, float range_min) {
  return std::isnan(range) || range <= 0.0f || range < range_min;
}

float usable(float intensity) { return std::isfinite(intensity) ? intensity : 0.0f; }

}  // namespace

std::string faultOf(const LaserSweep& sweep) {
  const auto& s = sweep;
  if (s.ranges.empty()) return "it has no ranges";
  if (!std::isfinite(s.angle_min) || !std::isfinite(s.angle_max))
    return "its angle_min or angle_max is not a number";
  if (!std::isfinite(s.angle_increment) || s.angle_increment == 0.0f)
    return fmt::format("its angle_increment is {}; it must be a number other than 0",
                       s.angle_increment);
  if (!std::isfinite(s.range_min) || s.range_min < 0.0f)
    return fmt::format("its range_min is {}; it must be 0 or above", s.range_min);
  if (!std::isfinite(s.range_max) || s.range_max <= s.range_min)
    return fmt::format("its range_max is {}; it must be a number above range_min", s.range_max);
  const double steps = (static_cast<double>(s.angle_max) - s.angle_min) / s.angle_increment;
  const auto beams = static_cast<double>(s.ranges.size());
  if (steps < 0.0)
    return fmt::format("its angles run from {} to {} and its angle_increment of {} the other way",
                       s.angle_min, s.angle_max, s.angle_increment);
  if (std::abs(steps + 1.0 - beams) > kBeamsOff)
    return fmt::format("it has {} ranges, while its angles tell {:.0f}", s.ranges.size(),
                       steps + 1.0);
  return "";
}

std::string faultOf(const LaserMount& mount) {
  if (auto fault = faultOfMount(mount.T_base_laser); !fault.empty()) return fault;
  const double up = std::abs(mount.T_base_laser.linear()(2, 2));
  if (up < std::cos(kMaxTilt))
    return fmt::format("the scan plane is tilted by {:.2f} rad and not horizontal",
                       std::acos(std::min(up, 1.0)));
  return "";
}

LaserScan toScan(const LaserSweep& sweep, const LaserMount& mount) {
  const auto& T = mount.T_base_laser;
  const double side = isUpsideDown(mount) ? -1.0 : 1.0;
  LaserScan scan;
  scan.stamp = sweep.stamp;
  scan.sensor_frame = sweep.frame;
  scan.sensor_pose = {T.translation().x(), T.translation().y(),
                      std::atan2(T.linear()(1, 0), T.linear()(0, 0))};
  scan.beams.reserve(sweep.ranges.size());
  const bool has_intensities = sweep.intensities.size() == sweep.ranges.size();
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    const float range = sweep.ranges[i];
    if (tellsNothing(range, sweep.range_min)) continue;
    const double angle =
        sweep.angle_min + static_cast<double>(i) * static_cast<double>(sweep.angle_increment);
    const bool hit = range <= sweep.range_max;
    const float intensity = has_intensities ? usable(sweep.intensities[i]) : 0.0f;
    scan.beams.push_back(
        {static_cast<float>(side * angle), hit ? range : sweep.range_max, hit, intensity});
  }
  return scan;
}

}  // namespace slam
