// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/LU>
#include <map>
#include <set>
#include <vector>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/mono_ekf/consensus.hpp"
#include "slam_core/mono_ekf/feature_seeds.hpp"
#include "slam_core/mono_ekf/test/point_cloud_drive.hpp"

namespace slam::test {

/// The filter over a drive whose points are recognised without fail.
class PointCloudFilter {
 public:
  static constexpr double kLeastSigma = 0.35;  ///< of the pixels [px]

  /// @param measured over true turn; where it is 1, all errors of the odometry are random
  explicit PointCloudFilter(std::uint64_t seed, double measured = 1.0)
      : drive_(seed),
        measured_(measured),
        noise_(kLeastSigma),
        errors_(measured == 1.0 ? 0.0 : 0.5),
        state_({Pose2(), 1e-6 * Eigen::Matrix3d::Identity()}) {}

  void stepInTheDark() { state_.predict(errors_.divide(drive_.move(measured_))); }
  void step() {
    if (steps_++ > 0) stepInTheDark();
    const auto seen = drive_.look();
    measure(seen);
    convertSure(state_, drive_.camera().centre(state_.robot().pose), 0.1);
    begin(seen);
  }

  void measure(const std::vector<PointCloudDrive::Pixel>& seen) {
    std::map<std::size_t, std::size_t> features;
    for (std::size_t i = 0; i < state_.features().size(); ++i)
      features[state_.features()[i].id] = i;
    std::vector<mono_ekf::Match> matches;
    for (const auto& [point, pixel] : seen)
      if (features.count(point) > 0 && matches.size() < 40)
        matches.push_back({features[point], pixel});
    const double sigma = noise_.sigma();
    const auto consensus = mono_ekf::consensusOf(state_, matches, drive_.camera(), sigma);
    noise_.learn(state_.update(consensus.measurements, sigma).score);
    if (2 * consensus.measurements.size() < matches.size()) noise_.doubt();
  }

  mono_ekf::MonoState& state() { return state_; }
  const PointCloudDrive& drive() const { return drive_; }
  PointCloudDrive& drive() { return drive_; }
  double pixelSigma() const { return noise_.sigma(); }
  /// The point that a feature is of.
  Eigen::Vector3d truthOf(const mono_ekf::Feature& feature) const {
    return drive_.points()[feature.id];
  }

  double headingError() const {
    return wrapAngle(state_.robot().pose.theta() - drive_.truth().theta());
  }
  double nees() const {
    Eigen::Vector3d error = state_.robot().pose.vector() - drive_.truth().vector();
    error.z() = headingError();
    return error.dot(state_.robot().covariance.inverse() * error);
  }

 private:
  void begin(const std::vector<PointCloudDrive::Pixel>& seen) {
    std::vector<mono_ekf::MonoState::Seed> seeds;
    for (const auto& [point, pixel] : seen) {
      if (!known_.insert(point).second) continue;
      auto seed = mono_ekf::raySeed(pixel, drive_.camera(), state_.robot().pose, 0.4);
      seed->feature.id = point;
      seeds.push_back(*seed);
    }
    state_.add(seeds, noise_.sigma(), 0.8);
  }

  PointCloudDrive drive_;
  double measured_;
  mono_ekf::PixelNoise noise_;
  mono_ekf::OdometryErrors errors_;
  mono_ekf::MonoState state_;
  std::set<std::size_t> known_;
  int steps_ = 0;
};

}  // namespace slam::test
