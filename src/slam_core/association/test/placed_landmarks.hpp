// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::association::test {

/// A map of exact landmarks around a robot at the origin, whose pose is uncertain: all innovations
/// have the pose's error in common.
class PlacedLandmarks final : public CandidateSource {
 public:
  PlacedLandmarks(const std::vector<Eigen::Vector2d>& places, const LandmarkObservationArray& array,
                  const Eigen::Matrix3d& P, std::vector<Descriptor> descriptors = {})
      : places_(places), array_(array), P_(P), descriptors_(std::move(descriptors)) {}

  std::size_t size() const override { return places_.size(); }
  std::optional<std::size_t> find(LandmarkId) const override { return std::nullopt; }
  void candidates(std::size_t observation, std::vector<Candidate>& candidates) const override {
    const auto& z = array_.observations[observation];
    for (std::size_t i = 0; i < places_.size(); ++i) {
      ObservationModel::Jacobian23 H;
      const auto predicted = model_.predict(Pose2(), array_.sensor_pose, places_[i], &H);
      candidates.push_back(
          {i, model_.innovation(z.vector(), predicted), H * P_ * H.transpose() + z.covariance});
    }
  }
  Descriptor descriptor(std::size_t landmark) const override {
    return landmark < descriptors_.size() ? descriptors_[landmark] : Descriptor();
  }
  Eigen::Matrix2d crossCovariance(const Pairing& first, const Pairing& second) const override {
    ObservationModel::Jacobian23 a, b;
    model_.predict(Pose2(), array_.sensor_pose, places_[first.landmark], &a);
    model_.predict(Pose2(), array_.sensor_pose, places_[second.landmark], &b);
    return a * P_ * b.transpose();
  }

 private:
  const std::vector<Eigen::Vector2d>& places_;
  const LandmarkObservationArray& array_;
  Eigen::Matrix3d P_;
  std::vector<Descriptor> descriptors_;
  RangeBearingModel model_;
};

/// What a sensor at the robot sees of a place.
inline LandmarkObservation observationOf(const Eigen::Vector2d& place,
                                         const Pose2& robot = Pose2()) {
  const auto seen = RangeBearingModel().predict(robot, Pose2(), place);
  LandmarkObservation z;
  z.range = seen.x();
  z.bearing = seen.y();
  z.covariance = Eigen::Vector2d(25e-4, 1e-4).asDiagonal();
  return z;
}

}  // namespace slam::association::test
