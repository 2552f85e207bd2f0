// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <deque>
#include <optional>
#include <string>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// Tests whether the mean of the innovations differs from zero. Noise of any size does not cause
/// that, but an offset of the bearings or a wrong scale of ranges or odometry does. Each step is
/// projected on the direction d in which such an error shifts all of its innovations together:
/// d^T S^-1 nu / sqrt(d^T S^-1 d), which is standard normal and white where all is right (Mehra and
/// Peschon 1971). The mean of the latest steps is compared with their scatter, including their
/// correlation from step to step, but at least with the predicted one: so a sigma that is too small
/// is not taken for a bias.
///
/// The innovations cannot distinguish an offset of the bearings from slip across the way, nor a
/// wrong scale of the ranges from one of the odometry. So the finding names the direction and both
/// causes.
class InnovationBias {
 public:
  enum Direction : std::size_t { kRange, kBearing, kAlong, kAcross, kDirections };

  /// The mean innovation along one direction.
  struct Mean {
    double size = 0.0;      ///< in standard deviations of a step
    double evidence = 0.0;  ///< against its being zero, in standard deviations
    int steps = 0;          ///< number of latest steps, chosen for the most evidence

    template <class Archive>
    void persist(Archive& archive) {
      archive(size, evidence, steps);
    }
  };

  /// @param window steps
  explicit InnovationBias(int window = 50) : window_(static_cast<std::size_t>(window)) {}

  /// To be called once for each step with observations that were used.
  void add(const JointInnovation& group, const PosePrediction& prediction);

  /// The direction with most evidence of a bias.
  Direction direction() const { return worst_; }
  const Mean& mean() const { return means_[worst_]; }
  /// "innovations are biased across the way by 0.9 standard deviations (...)"
  std::string finding() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(steps_, means_, worst_);
  }

 private:
  using Step = std::array<std::optional<double>, kDirections>;
  Mean judge(Direction direction) const;

  std::size_t window_;
  std::deque<Step> steps_;
  std::array<Mean, kDirections> means_;
  Direction worst_ = kRange;
};

}  // namespace slam
