// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <deque>
#include <optional>
#include <string>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// Whether the innovations are off zero in the mean, which noise of whatever size is not: a bearing
/// offset, ranges or odometry of a wrong scale. Each step is projected on what such an error does
/// to all of its innovations together, d^T S^-1 nu / sqrt(d^T S^-1 d), which is standard normal and
/// white where all is right (Mehra and Peschon 1971). The mean of the latest steps is judged by how
/// much they scatter, correlation from step to step included, but by no less than is believed: so a
/// sigma that is too small is not taken for a bias.
///
/// To the innovations an offset of the bearings is the same as slip across the way, and a wrong
/// scale of ranges the same as one of the odometry. So the finding names the direction and both.
class InnovationBias {
 public:
  enum Direction : std::size_t { kRange, kBearing, kAlong, kAcross, kDirections };

  /// What a window says of one direction.
  struct Mean {
    double size = 0.0;      ///< in standard deviations of a step
    double evidence = 0.0;  ///< against its being zero, in standard deviations
    int steps = 0;          ///< the latest ones, that show it best
  };

  /// @param window steps
  explicit InnovationBias(int window = 50) : window_(static_cast<std::size_t>(window)) {}

  /// Once for each step with observations that were used.
  void add(const JointInnovation& group, const PosePrediction& prediction);

  /// The direction of most evidence.
  Direction direction() const { return worst_; }
  const Mean& mean() const { return means_[worst_]; }
  /// "innovations are biased across the way by 0.9 standard deviations (...)"
  std::string finding() const;

 private:
  using Step = std::array<std::optional<double>, kDirections>;
  Mean judge(Direction direction) const;

  std::size_t window_;
  std::deque<Step> steps_;
  std::array<Mean, kDirections> means_;
  Direction worst_ = kRange;
};

}  // namespace slam
