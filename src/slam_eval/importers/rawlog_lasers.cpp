// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_lasers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace slam::eval {
namespace {

using mrpt::obs::CObservation2DRangeScan;

constexpr double kLevel = 0.1;  // [rad]: a laser tilted by more scans no plane of the floor

float rangeOf(const CObservation2DRangeScan& scan, std::size_t beam) {
  const float range = scan.getScanRange(beam);
  if (range >= scan.maxRange) return std::numeric_limits<float>::infinity();
  return scan.getScanRangeValidity(beam) ? range : std::numeric_limits<float>::quiet_NaN();
}

/// Neither pitched nor rolled, but perhaps upside down.
bool isLevel(const RawlogLog::Laser& laser) {
  return std::abs(std::sin(laser.pitch)) < kLevel && std::abs(std::sin(laser.roll)) < kLevel;
}

}  // namespace

std::optional<LaserReading> toReading(const CObservation2DRangeScan& scan) {
  const std::size_t beams = scan.getScanSize();
  if (beams < 2 || !(scan.aperture > 0.0f) || !(scan.maxRange > 0.0f)) return std::nullopt;
  LaserReading reading;
  // MRPT's aperture is a float: half a circle would miss its last beam by 1e-7 rad.
  const double aperture = static_cast<double>(scan.aperture);
  reading.start_angle = -aperture / 2.0;
  reading.increment = aperture / static_cast<double>(beams - 1);
  reading.max_range = static_cast<double>(scan.maxRange);
  for (std::size_t i = 0; i < beams; ++i) reading.ranges.push_back(rangeOf(scan, i));
  if (!scan.rightToLeft) std::reverse(reading.ranges.begin(), reading.ranges.end());
  return reading;
}

std::size_t RawlogLasers::add(const CObservation2DRangeScan& scan) {
  const auto& pose = scan.sensorPose;
  const RawlogLog::Laser laser{scan.sensorLabel, pose.x(),     pose.y(),    pose.z(),
                               pose.yaw(),       pose.pitch(), pose.roll(), 0};
  const auto same = [&](const RawlogLog::Laser& other) {
    return std::tie(other.label, other.x, other.y, other.z, other.yaw, other.pitch, other.roll) ==
           std::tie(laser.label, laser.x, laser.y, laser.z, laser.yaw, laser.pitch, laser.roll);
  };
  auto found = std::find_if(lasers_.begin(), lasers_.end(), same);
  if (found == lasers_.end()) found = lasers_.insert(lasers_.end(), laser);
  ++found->scans;
  return static_cast<std::size_t>(found - lasers_.begin());
}

std::optional<std::size_t> mainLaser(const std::vector<RawlogLog::Laser>& lasers) {
  if (lasers.empty()) return std::nullopt;
  const auto rank = [](const RawlogLog::Laser& laser) {
    return std::make_tuple(!isLevel(laser), std::abs(laser.yaw), -static_cast<double>(laser.scans));
  };
  const auto best =
      std::min_element(lasers.begin(), lasers.end(),
                       [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return static_cast<std::size_t>(best - lasers.begin());
}

}  // namespace slam::eval
