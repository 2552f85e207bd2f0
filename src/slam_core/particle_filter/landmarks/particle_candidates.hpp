// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/models/observation_model.hpp"
#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"
#include "slam_core/particle_filter/landmarks/landmark_index.hpp"
#include "slam_core/particle_filter/particles/particle_map.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"

namespace slam::particle_filter {

/// The maps of all particles for a policy that asks for ids only: all of them have the same
/// landmarks, in the same slots.
class IdCandidates final : public association::CandidateSource {
 public:
  explicit IdCandidates(const LandmarkIndex& index) : index_(index) {}

  std::size_t size() const override { return index_.size(); }
  std::optional<std::size_t> find(LandmarkId id) const override { return index_.find(id); }
  void candidates(std::size_t /*observation*/,
                  std::vector<association::Candidate>& /*candidates*/) const override {}

 private:
  const LandmarkIndex& index_;
};

/// One particle's map for a policy that asks for places as well. Landmarks are numbered by the
/// particle's slots; predictions are those at the mean of its prior.
class PlaceCandidates final : public association::CandidateSource {
 public:
  /// @param prior where motion alone puts the particle
  /// @param gate largest squared Mahalanobis distance; all within it are found, and some beyond
  PlaceCandidates(const LandmarkObservationArray& array, const LandmarkIndex& index,
                  const association::DescriptorMap& descriptors, const ParticleMap& map,
                  const PoseGaussian& prior, const ObservationModel& model, double gate)
      : array_(array),
        index_(index),
        descriptors_(descriptors),
        map_(map),
        prior_(prior),
        model_(model),
        gate_(gate) {}

  std::size_t size() const override { return map_.size(); }
  std::optional<std::size_t> find(LandmarkId id) const override;
  void candidates(std::size_t observation,
                  std::vector<association::Candidate>& candidates) const override;
  Descriptor descriptor(std::size_t slot) const override {
    return descriptors_.of(index_.id(map_[slot].number));
  }
  /// What the doubt of the prior makes them have in common.
  Eigen::Matrix2d crossCovariance(const association::Pairing& first,
                                  const association::Pairing& second) const override;

 private:
  std::optional<Expectation> expectation(const association::Pairing& pairing) const;

  const LandmarkObservationArray& array_;
  const LandmarkIndex& index_;
  const association::DescriptorMap& descriptors_;
  const ParticleMap& map_;
  const PoseGaussian& prior_;
  const ObservationModel& model_;
  double gate_;
};

}  // namespace slam::particle_filter
