// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/sensor_reach.hpp"

#include <algorithm>
#include <cmath>

namespace slam::association {
namespace {

/// A sector tells something after so many observations; from then on, older ones are forgotten.
constexpr int kReachCount = 10, kReachMemory = 200;

}  // namespace

std::size_t SensorReach::sectorOf(double bearing) {
  const double share = (std::remainder(bearing, 2.0 * M_PI) + M_PI) / (2.0 * M_PI);
  return static_cast<std::size_t>(std::clamp(int(share * kSectors), 0, kSectors - 1));
}

/// What is seen lies anywhere up to the limit: most of it beyond half, and the mean well within.
double SensorReach::reachOf(const Sector& sector) {
  return sector.count < kReachCount ? 0.0 : sector.range;
}

void SensorReach::see(const LandmarkObservationArray& array) {
  for (const auto& z : array.observations) {
    auto& sector = sectors_[sectorOf(z.bearing)];
    sector.count = std::min(sector.count + 1, kReachMemory);
    sector.range += (z.range - sector.range) / sector.count;
  }
}

bool SensorReach::covers(const Eigen::Vector2d& place) const {
  const double range = place.norm();
  return range > 0.0 && range < reachOf(sectors_[sectorOf(std::atan2(place.y(), place.x()))]);
}

double SensorReach::area() const {
  double sum = 0.0;
  for (const auto& sector : sectors_) sum += std::pow(reachOf(sector), 2);
  return std::max(1.0, 0.5 * sum * 2.0 * M_PI / kSectors);
}

}  // namespace slam::association
