// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/ekf/observation_update.hpp"

namespace slam::ekf {

/// The landmarks that the observations of a stamp may be of.
LandmarksInView landmarksById(const LandmarkObservationArray& array, const EkfState& state);

/// The same by place: for each observation those around where it puts a landmark.
struct LandmarksByPlace {
  std::vector<std::vector<Eigen::Index>> of;  ///< by observation

  LandmarksInView all() const;
};
/// @param gate largest squared Mahalanobis distance; all within it are found, and some beyond
LandmarksByPlace landmarksByPlace(const LandmarkObservationArray& array, const EkfState& state,
                                  const ObservationModel& model, double gate);

/// The EKF's map for a policy that asks for ids only.
class IdCandidates : public association::CandidateSource {
 public:
  explicit IdCandidates(const EkfState& state) : state_(state) {}

  std::size_t size() const override { return state_.landmarks(); }
  std::optional<std::size_t> find(LandmarkId id) const override { return state_.find(id); }
  void candidates(std::size_t /*observation*/,
                  std::vector<association::Candidate>& /*candidates*/) const override {}

 protected:
  const EkfState& state_;
};

/// The EKF's map for a policy that asks for places as well: the landmarks that were found must have
/// been taken into the neighbourhood.
class PlaceCandidates final : public IdCandidates {
 public:
  PlaceCandidates(const LandmarkObservationArray& array, const EkfState& state,
                  const ObservationModel& model, const LandmarksByPlace& near,
                  const association::DescriptorMap& descriptors);

  void candidates(std::size_t observation,
                  std::vector<association::Candidate>& candidates) const override;
  Descriptor descriptor(std::size_t landmark) const override {
    return descriptors_.of(state_.id(landmark));
  }
  Eigen::Matrix2d crossCovariance(const association::Pairing& first,
                                  const association::Pairing& second) const override;

 private:
  /// A pairing, linearised at the prediction.
  struct Linear {
    std::size_t landmark;
    Innovation innovation;
  };
  const Innovation* find(const association::Pairing& pairing) const;

  const association::DescriptorMap& descriptors_;
  std::vector<std::vector<Linear>> near_;  ///< by observation
};

}  // namespace slam::ekf
