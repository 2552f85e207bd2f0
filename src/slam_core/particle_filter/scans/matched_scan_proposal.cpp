// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/particle_filter/scans/scan_proposal.hpp"

namespace slam::particle_filter {
namespace {

using grid_map::MatchObjective;

/// A step along each axis of the robot's frame [m, m, rad].
using Steps = Eigen::Array3d;

Pose2 moved(const Pose2& pose, const Steps& step) {
  return pose * Pose2(step.x(), step.y(), step.z());
}

/// How far neighbours of a lattice about a mode lie apart, as wide as the objective bends there.
Steps stepsAbout(const Pose2& mode, const MatchObjective& objective) {
  const Steps probe(0.02, 0.02, 0.01);
  constexpr double kSigmas = 1.5, kLeast = 0.1, kMost = 4.0;
  const double at_mode = objective.log(mode);
  Steps steps;
  for (int axis = 0; axis < 3; ++axis) {
    Steps step = Steps::Zero();
    step[axis] = probe[axis];
    const double drop =
        2.0 * at_mode - objective.log(moved(mode, step)) - objective.log(moved(mode, -step));
    const double sigma = drop > 0.0 ? 1.0 / std::sqrt(drop) : kMost;  // in probes
    steps[axis] = kSigmas * probe[axis] * std::clamp(sigma, kLeast, kMost);
  }
  return steps;
}

/// What the objective makes of the poses of a lattice of three by three by three.
class Samples {
 public:
  Samples(const Pose2& mode, const Steps& steps, const MatchObjective& objective) {
    std::size_t k = 0;
    for (const double x : {-1.0, 0.0, 1.0})
      for (const double y : {-1.0, 0.0, 1.0})
        for (const double turn : {-1.0, 0.0, 1.0}) {
          const Pose2 pose = moved(mode, steps * Steps(x, y, turn));
          deviations_[k] = pose.vector() - mode.vector();
          deviations_[k].z() = wrapAngle(deviations_[k].z());
          logs_[k++] = objective.log(pose);
        }
  }

  double largestLog() const { return *std::max_element(logs_.begin(), logs_.end()); }

  /// Mean and covariance of the deviations from the mode.
  /// @param sum of the weights relative to the largest, written
  std::pair<Eigen::Vector3d, Eigen::Matrix3d> moments(double& sum) const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    const double largest = largestLog();
    sum = 0.0;
    for (std::size_t k = 0; k < logs_.size(); ++k) {
      const double weight = std::exp(logs_[k] - largest);
      sum += weight;
      mean += weight * deviations_[k];
      moment += weight * deviations_[k] * deviations_[k].transpose();
    }
    mean /= sum;
    return {mean, moment / sum - mean * mean.transpose()};
  }

 private:
  static constexpr std::size_t kCount = 27;
  std::array<Eigen::Vector3d, kCount> deviations_;
  std::array<double, kCount> logs_;
};

}  // namespace

ScanDraft MatchedScanProposal::propose(const grid_map::ScanLikelihood& likelihood,
                                       const grid_map::ScanPoints& scan,
                                       const grid_map::GridMap& map, const PoseGaussian& prior,
                                       RandomStream&) const {
  const bool is_nothing_to_match = scan.ends.empty() || map.isEmpty();
  if (is_nothing_to_match || prior.isCertain() || !scan.isOnMap(prior.mean))
    return {prior, likelihood.log(map, scan, prior.mean)};
  const MatchObjective objective(likelihood, map, scan, prior.mean, prior.covariance);
  const Pose2 mode = matcher_->match(objective).pose;
  const Steps steps = stepsAbout(mode, objective);
  const Samples samples(mode, steps, objective);
  double sum = 0.0;
  const auto [mean, covariance] = samples.moments(sum);
  // each sample stands for a cell of the lattice
  const double log_integral = samples.largestLog() + std::log(sum) + steps.log().sum();
  return {{Pose2::fromVector(mode.vector() + mean), covariance}, log_integral};
}

}  // namespace slam::particle_filter
