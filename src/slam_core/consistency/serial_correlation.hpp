// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <deque>
#include <map>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// Whether the innovations of a landmark are alike from one update to the next. Where a sensor's
/// noise is larger than believed they are not, the filter follows the noise and they even
/// alternate; where something is wrong for good, or the pose is lost, they are.
class SerialCorrelation {
 public:
  enum Component : std::size_t { kRange, kBearing, kComponents };

  /// @param window steps
  explicit SerialCorrelation(int window = 50) : window_(static_cast<std::size_t>(window)) {}

  void add(const std::vector<ObservationInnovation>& innovations);

  /// The coefficient is in [-1, 1], and below 0 where the innovations alternate.
  double coefficient(Component component) const;

 private:
  /// Sums of the products of one innovation with the next, and of squares.
  struct Sums {
    double products = 0.0, squares = 0.0;
  };
  using Step = std::array<Sums, kComponents>;

  std::size_t window_;
  std::map<LandmarkId, Eigen::Vector2d> previous_;
  std::deque<Step> steps_;
};

}  // namespace slam
