// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/association/place_evidence.hpp"
#include "slam_core/models/observation_model.hpp"
#include "slam_core/particle_filter/landmarks/landmark_index.hpp"
#include "slam_core/particle_filter/landmarks/sight.hpp"
#include "slam_core/particle_filter/particles/particle_set.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"
#include "slam_core/particle_filter/particles/workers.hpp"

namespace slam::particle_filter {

/// What the particles take the observations of a stamp for.
struct Association {
  std::vector<Sight> sights{Sight()};     ///< one that holds for all particles, or one for each
  std::vector<LandmarkObservation> seen;  ///< observations of known landmarks, by column

  const Sight& of(std::size_t particle) const { return sights[sights.size() > 1 ? particle : 0]; }
};

/// Asks the policy of which landmarks the observations of a stamp are: once for all particles where
/// it depends on ids only, which all particles have in common; else each particle for itself, as
/// each has a map of its own, and a policy for each lane of the workers.
class Associator {
 public:
  struct Config {
    std::string policy = "known_ids";
    unsigned lanes = 1;
    double gate = 0.0;  ///< largest squared Mahalanobis distance
    bool map_is_fixed = false;
    association::PolicyConfig of_policy;
  };

  explicit Associator(const Config& config);

  /// Starts over with a map.
  void restart(const LandmarkMap& map);
  void move(const Motion& motion) { evidence_.move(motion); }
  /// To be called before forEach().
  void see(const LandmarkObservationArray& array) { evidence_.see(array); }
  /// The most likely particle has re-initialised a landmark.
  /// @return whether it is to be removed instead
  bool distrusts(LandmarkId id, bool was_confirmed) {
    descriptors_.forget(id);
    return evidence_.distrusts(id, was_confirmed);
  }
  /// A landmark was removed on request.
  void forget(LandmarkId id) {
    evidence_.forget(id);
    descriptors_.forget(id);
  }
  /// The most likely particle has taken the observation for this landmark, which gets its
  /// descriptor. All particles share the descriptors.
  void describe(LandmarkId id, const LandmarkObservation& z) { descriptors_.see(id, z.descriptor); }
  const association::DescriptorMap& descriptors() const { return descriptors_; }
  /// After the update: landmarks that are not there, to be removed.
  /// @param sensor T_map_sensor of the most likely particle
  /// @param seen its landmarks that were seen
  std::vector<LandmarkId> ghosts(const Pose2& sensor,
                                 const std::vector<association::LandmarkPlace>& landmarks,
                                 const std::vector<LandmarkId>& seen) {
    return evidence_.ghosts(sensor, landmarks, seen);
  }

  /// Whether forEach() is to be called, and not forAll().
  bool asksEach() const { return lanes_.front().policy->usesPlaces(); }
  Association forAll(const LandmarkObservationArray& array, const LandmarkIndex& index);
  /// @param priors where motion alone puts the particles
  Association forEach(const LandmarkObservationArray& array, const LandmarkIndex& index,
                      const ObservationModel& model, const ParticleSet& particles,
                      const std::vector<PoseGaussian>& priors, Workers& workers);

  template <class Archive>
  void persist(Archive& archive) {
    archive(evidence_, descriptors_);
  }

 private:
  using Source = association::CandidateSource;

  Sight ask(const LandmarkObservationArray& array, const Source& source, std::size_t lane);

  struct Lane {
    std::unique_ptr<association::AssociationPolicy> policy;
    std::vector<association::Decision> decisions;
  };
  Config config_;
  std::vector<Lane> lanes_;
  association::PlaceEvidence evidence_;
  association::DescriptorMap descriptors_;
};

}  // namespace slam::particle_filter
