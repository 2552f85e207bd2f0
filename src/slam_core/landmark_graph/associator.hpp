// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/association/place_evidence.hpp"
#include "slam_core/association/sightings.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/landmark_graph/path_graph.hpp"

namespace slam::landmark_graph {

/// This says how observations are associated.
struct AssociationConfig {
  std::string policy = "known_ids";
  double gate_probability = 0.9999;  ///< that a right observation passes the gate
  association::PlaceConfig places;
  bool map_is_fixed = false;
};

/// How the observations of one stamp relate to the graph.
struct Association {
  std::vector<Match> matches;               ///< of known landmarks, within the gate
  std::vector<LandmarkObservation> unseen;  ///< of landmarks that are not in the graph yet
  std::vector<Match> gated;                 ///< of known landmarks, outside the gate
  bool is_solved = true;                    ///< the matches' covariance is positive definite
  /// One for each observation, where places decide; those of new landmarks have no landmark yet.
  std::vector<AssociatedObservation> taken;
};

/// @return what went wrong when the observations of one stamp were associated, and the graph solved
/// @param needs_map the back-end only localises, in a map of landmarks
Status statusOf(const Association& association, const PathGraph& path,
                const LandmarkGraph& landmarks, bool needs_map);

/// @return the verdicts of `sightings` on the landmarks that were observed, by the observations
/// that fit and those that are gated
std::vector<association::Sightings::Verdict> judged(association::Sightings& sightings,
                                                    const Association& association);

/// Asks the policy once for all observations of a stamp, and gates those that it takes for known
/// landmarks: each must pass the chi-square test on its own. Counted: "duplicate", "gated",
/// "unknown_id", "not_in_map", "ambiguous", "on_trial", "distrusted_id".
class Associator {
 public:
  Associator() = default;
  explicit Associator(const AssociationConfig& config);

  /// Starts over with a map.
  void restart(const LandmarkMap& map);
  void move(const Motion& motion) { evidence_.move(motion); }
  /// @param statistics what is known of the innovations is added
  Association associate(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                        UpdateStatistics& statistics, Counters& counters);
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
  /// A landmark was put into the graph by an observation.
  void begin(LandmarkId id, const LandmarkObservation& z) { descriptors_.set(id, z.descriptor); }
  const association::DescriptorMap& descriptors() const { return descriptors_; }
  /// The descriptors are those of another map.
  void describeBy(const LandmarkMap& map) { descriptors_ = association::DescriptorMap(map); }
  /// Whether ids are not looked at.
  bool goesByPlace() const { return policy_->usesPlaces(); }
  /// After the update: landmarks that are not there, to be removed.
  std::vector<LandmarkId> ghosts(const Association& association, const LandmarkGraph& graph,
                                 const Pose2& sensor);

  template <class Archive>
  void persist(Archive& archive) {
    archive(evidence_, descriptors_);
  }

 private:
  void decide(const LandmarkObservationArray& array, const LandmarkGraph& graph);
  std::vector<Match> sort(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                          Association& association, UpdateStatistics& statistics,
                          Counters& counters) const;
  void gate(const std::vector<Match>& known, const Pose2& sensor, const LandmarkGraph& graph,
            Association& association, UpdateStatistics& statistics) const;
  void recordMatches(const LandmarkGraph& graph, Association& association) const;

  std::unique_ptr<association::AssociationPolicy> policy_;
  association::PlaceConfig places_;
  association::PlaceEvidence evidence_;
  association::DescriptorMap descriptors_;
  double gate_ = 0.0;  ///< largest squared Mahalanobis distance
  bool map_is_fixed_ = false;
  std::vector<association::Decision> decisions_;
};

}  // namespace slam::landmark_graph
