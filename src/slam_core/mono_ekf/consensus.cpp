// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/consensus.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/mono_ekf/invariant_step.hpp"

namespace slam::mono_ekf {
namespace {

constexpr double kNearSigmas = 2.45;  // the radius that holds 95 % of a Gaussian in the plane

/// The robot and the matched features alone, in the order of the matches.
class MatchedPart {
 public:
  MatchedPart(const MonoState& state, const std::vector<Match>& matches, const PlanarCamera& camera,
              double sigma)
      : matches_(matches), camera_(camera), sigma_(sigma), belief_(partOf(state, matches)) {}

  /// The best set of inliers that one match leads to; the first of several that are as good.
  std::vector<bool> bestHypothesis() const {
    std::vector<bool> best(matches_.size(), false);
    std::ptrdiff_t most = 0;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const auto measurement = measured(i, belief_.mean());
      if (!measurement) continue;
      auto near = nearTo(meanAfter(belief_, *measurement, sigma_));
      const auto count = std::count(near.begin(), near.end(), true);
      if (count <= most) continue;
      most = count;
      best = std::move(near);
    }
    return best;
  }

  void update(const std::vector<bool>& used) {
    std::vector<Measurement> measurements;
    for (std::size_t i = 0; i < used.size(); ++i)
      if (const auto measurement = measured(i, belief_.mean()); used[i] && measurement)
        measurements.push_back(*measurement);
    belief_.update(measurements, sigma_);
  }

  /// @return which matches have an innovation that passes the gate
  std::vector<bool> gated() const {
    std::vector<bool> fit;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const auto measurement = measured(i, belief_.mean());
      fit.push_back(measurement && passesGate(*measurement));
    }
    return fit;
  }

  /// The matches that agree say by how much the scale of what is seen has changed.
  double scaleSince(const MonoState& before, const std::vector<bool>& agrees) const {
    std::vector<int> offsets;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(before.mean().size());
    change.head<2>() = belief_.mean().head<2>() - before.mean().head<2>();
    for (std::size_t i = 0; i < agrees.size(); ++i) {
      if (!agrees[i]) continue;
      const auto& original = before.features()[matches_[i].feature];
      offsets.push_back(original.offset);
      change.segment(original.offset, original.size()) =
          coordinatesOf(belief_, belief_.features()[i]) - coordinatesOf(before, original);
    }
    return ScaleError(before, offsets).of(change);
  }

  /// Against the state before, linearised at what is believed now. @param s scaleSince(before)
  Measurement relinearised(std::size_t match, const MonoState& before, double s) const {
    const auto& original = before.features()[matches_[match].feature];
    auto measurement = *measured(match, belief_.mean());
    auto& [pixel, J_pose, J_feature] = measurement.prediction;
    const Eigen::Vector3d now = belief_.mean().head<3>(), then = before.mean().head<3>();
    const Eigen::VectorXd y_now = coordinatesOf(belief_, belief_.features()[match]),
                          y_then = coordinatesOf(before, original);
    const MapStep map{wrapAngle(now.z() - then.z()), s};
    Eigen::Vector3d pose_step(0.0, 0.0, map.alpha);
    pose_step.head<2>() = stepBetween(then.head<2>(), now.head<2>(), map);
    const Eigen::Vector2d moved = now.head<2>() - then.head<2>();
    const Eigen::VectorXd y_moved = y_now - y_then;
    measurement.J_scale =
        J_pose.leftCols<2>() * moved + J_feature * addedByScale(original, y_moved);
    J_pose.col(2) += J_pose.leftCols<2>() * turnedLeft(moved) + J_feature * addedByHeading(y_moved);
    measurement.nu += J_pose * pose_step + J_feature * stepBetween(original, y_then, y_now, map) +
                      measurement.J_scale * s;
    measurement.offset = original.offset;
    return measurement;
  }

 private:
  static MonoState partOf(const MonoState& state, const std::vector<Match>& matches) {
    std::vector<std::size_t> features;
    for (const auto& match : matches) features.push_back(match.feature);
    return mono_ekf::partOf(state, features);
  }

  std::optional<Measurement> measured(std::size_t match, const Eigen::VectorXd& mean) const {
    const auto& feature = belief_.features()[match];
    const auto prediction = predictedPixel(camera_, Pose2::fromVector(mean.head<3>()), feature,
                                           mean.segment(feature.offset, feature.size()));
    if (!prediction) return std::nullopt;
    return Measurement{feature.offset, *prediction, matches_[match].pixel - prediction->pixel};
  }

  std::vector<bool> nearTo(const Eigen::VectorXd& mean) const {
    std::vector<bool> near;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const auto measurement = measured(i, mean);
      near.push_back(measurement && measurement->nu.norm() <= kNearSigmas * sigma_);
    }
    return near;
  }

  bool passesGate(const Measurement& measurement) const {
    const Eigen::Matrix2d S =
        predictedCovariance(belief_, measurement.offset, measurement.prediction) +
        sigma_ * sigma_ * Eigen::Matrix2d::Identity();
    return measurement.nu.dot(S.inverse() * measurement.nu) <= kPixelGate;
  }

  const std::vector<Match>& matches_;
  const PlanarCamera& camera_;
  double sigma_;
  MonoState belief_;
};

}  // namespace

Consensus consensusOf(const MonoState& state, const std::vector<Match>& matches,
                      const PlanarCamera& camera, double sigma) {
  MatchedPart part(state, matches, camera, sigma);
  part.update(part.bestHypothesis());
  Consensus consensus{part.gated(), {}};
  const double s = part.scaleSince(state, consensus.agrees);
  for (std::size_t i = 0; i < matches.size(); ++i)
    if (consensus.agrees[i]) consensus.measurements.push_back(part.relinearised(i, state, s));
  return consensus;
}

}  // namespace slam::mono_ekf
