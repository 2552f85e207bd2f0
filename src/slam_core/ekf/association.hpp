// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/association/place_evidence.hpp"
#include "slam_core/association/sightings.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/ekf/ekf_config.hpp"
#include "slam_core/ekf/observation_update.hpp"

namespace slam::ekf {

/// How the observations of one stamp are associated with the map.
struct Association {
  std::vector<Match> matches;                      ///< of known landmarks, within the gate
  std::vector<LandmarkObservation> unseen;         ///< of landmarks that are not in the map yet
  std::vector<LandmarkObservation> gated;          ///< of known landmarks, outside the gate
  std::vector<ObservationInnovation> innovations;  ///< of known landmarks, gated ones included
  double gated_log_likelihood = 0.0;               ///< of the gated ones
  /// One for each observation, where places decide; those of new landmarks have no landmark yet.
  std::vector<AssociatedObservation> taken;
  int unknown = 0;  ///< without an id, or of a landmark that is not in a fixed map
};

/// Brings the landmarks that may have been observed into the neighbourhood, asks the policy once
/// for all observations of a stamp, and gates what it takes for known landmarks: each observation
/// must pass the chi-square test on its own. Counted: "duplicate", "gated", "unknown_id",
/// "not_in_map", "ambiguous", "on_trial", "distrusted_id".
class Associator {
 public:
  Associator() = default;
  explicit Associator(const EkfConfig& config);

  /// Starts over with a map.
  void restart(const LandmarkMap& map);
  void move(const Motion& motion) { evidence_.move(motion); }
  Association associate(const LandmarkObservationArray& array, EkfState& state,
                        const ObservationModel& model, Counters& counters);
  /// A landmark is to be re-initialised. @return whether it is to be removed instead
  bool distrusts(const association::Sightings::Verdict& verdict) {
    descriptors_.forget(verdict.z.id);
    return evidence_.distrusts(verdict.z.id, verdict.was_confirmed);
  }
  /// A landmark was removed on request.
  void forget(LandmarkId id) {
    evidence_.forget(id);
    descriptors_.forget(id);
  }
  /// A landmark was put into the map by an observation.
  void begin(LandmarkId id, const LandmarkObservation& z) { descriptors_.set(id, z.descriptor); }
  const association::DescriptorMap& descriptors() const { return descriptors_; }
  /// After the update: landmarks that are not there, to be removed.
  std::vector<LandmarkId> ghosts(const Association& association, const EkfState& state,
                                 const Pose2& sensor);

  template <class Archive>
  void persist(Archive& archive) {
    archive(evidence_, descriptors_);
  }

 private:
  using Decision = association::Decision;

  void decide(const LandmarkObservationArray& array, EkfState& state,
              const ObservationModel& model);
  std::vector<Decision::Kind> checked(const EkfState& state) const;
  void match(std::size_t observation, const LandmarkObservationArray& array, const EkfState& state,
             const ObservationModel& model, Association& association) const;
  void sort(const LandmarkObservationArray& array, const EkfState& state,
            const ObservationModel& model, Association& association, Counters& counters) const;
  bool passesGate(const Match& match, const EkfState& state, const ObservationModel& model,
                  const Pose2& sensor, Association& association) const;

  std::unique_ptr<association::AssociationPolicy> policy_;
  association::PlaceConfig places_;
  association::PlaceEvidence evidence_;
  association::DescriptorMap descriptors_;
  double gate_ = 0.0;       ///< largest squared Mahalanobis distance
  int linearizations_ = 1;  ///< of an observation before it is gated, see ObservationUpdate
  bool map_is_fixed_ = false;
  std::vector<association::Decision> decisions_;
};

}  // namespace slam::ekf
