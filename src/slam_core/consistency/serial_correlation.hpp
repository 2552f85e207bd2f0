// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <deque>
#include <map>
#include <vector>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// The correlation of a landmark's innovations from one update to the next. If the noise of a
/// sensor is larger than assumed, they are not correlated, or they even alternate as the filter
/// follows the noise. If there is a systematic error, or the pose is lost, they are correlated.
class SerialCorrelation {
 public:
  enum Component : std::size_t { kRange, kBearing, kComponents };

  /// @param window steps
  explicit SerialCorrelation(int window = 50) : window_(static_cast<std::size_t>(window)) {}

  void add(const std::vector<ObservationInnovation>& innovations);

  /// The coefficient of correlation, in [-1, 1]; below 0 if the innovations alternate.
  double coefficient(Component component) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(previous_, steps_);
  }

 private:
  /// The sums of the products of successive innovations, and of their squares.
  struct Sums {
    double products = 0.0, squares = 0.0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(products, squares);
    }
  };
  using Step = std::array<Sums, kComponents>;

  std::size_t window_;
  std::map<LandmarkId, Eigen::Vector2d> previous_;
  std::deque<Step> steps_;
};

}  // namespace slam
