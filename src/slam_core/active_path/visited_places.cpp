// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/visited_places.hpp"

#include <algorithm>

namespace slam::active_path {
namespace {

constexpr double kSpacing = 0.5;  // [m]

}  // namespace

void VisitedPlaces::note(const Eigen::Vector2d& position, double sigma) {
  if (!places_.empty()) way_ += (position - last_).norm();
  last_ = position;
  bool is_known = false;
  for (auto& place : places_) {
    if ((place.position - position).norm() >= kSpacing) continue;
    is_known = true;
    place.way = way_;
    place.sigma = std::min(place.sigma, sigma);
  }
  if (!is_known) places_.push_back({position, sigma, way_});
}

}  // namespace slam::active_path
