// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "slam_core/particle_filter/landmarks/associator.hpp"
#include "slam_core/particle_filter/landmarks/fit_monitor.hpp"
#include "slam_core/particle_filter/landmarks/landmark_index.hpp"
#include "slam_core/particle_filter/landmarks/proposal.hpp"
#include "slam_core/particle_filter/landmarks/weighting.hpp"
#include "slam_core/particle_filter/particles/sensor_update.hpp"

namespace slam::particle_filter {

/// Landmarks in the filter: FastSLAM (Montemerlo 2003; thesis 5.4). Without observations it moves
/// the particles by motion alone.
class LandmarkUpdate final : public SensorUpdate {
 public:
  struct Config {
    std::string association = "known_ids";
    std::string proposal = "fastslam2", weighting = "predictive";
    double gate_probability = 0.9999;
    double lost_nis = 5.0;
    bool map_is_fixed = false;
    unsigned lanes = 1;  ///< of the workers, at most
    association::PlaceConfig places;
  };

  /// There are no landmarks yet. @param config is valid
  explicit LandmarkUpdate(const Config& config);
  LandmarkUpdate() : LandmarkUpdate(Config()) {}

  /// These are the landmarks of the particles' maps, in this order.
  void load(const LandmarkMap& map);
  /// This does what LandmarkRemover::remove() promises.
  Status remove(LandmarkId id, Account& account);
  /// All motion, that of steps without observations as well; before take().
  void move(const Motion& motion) { associator_.move(motion); }
  /// The robot is elsewhere: how observations fitted before says nothing any more.
  void relocate() { fit_.forget(); }

  /// The observations of a step, or none; what is left out is counted as "unknown_id", "duplicate",
  /// "not_in_map", "ambiguous", "on_trial", "distrusted_id", by the most likely particle where each
  /// decides for itself.
  /// @return whether there may be a landmark among them
  bool take(const std::optional<LandmarkObservationArray>& array, Account& account);

  Drafts propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                 const PoseBelief& belief, const Execution& execution) override;
  void judge(const Weights& weights, Account& account) override;
  void inform(const PoseEstimate& moments, const ParticleSet& particles,
              KnowledgeBound& bound) const override;
  double logCorrection(const Drafts& drafts, std::size_t ancestor,
                       const Particle& drawn) const override;
  Lesson learn(ParticleSet& particles, const Ancestors& ancestors, PoseBelief& belief,
               const Execution& execution, Account& account) override;

  const LandmarkIndex& index() const { return index_; }
  const association::DescriptorMap& descriptors() const { return associator_.descriptors(); }
  bool isLost() const { return fit_.isLost(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(associator_, index_, fit_, established_, array_, has_seen_);
  }

 private:
  bool isDoubtful() const { return has_seen_ && fit_.isDoubtful(); }
  const Prediction* predictionsOf(std::size_t particle) const {
    return predictions_.data() + particle * association_.seen.size();
  }
  bool mayMatch() const;
  void expectNothing(const Sight& sight, Prediction* predictions) const;
  void begin(const Ancestors& ancestors, PoseBelief& belief);
  void updateMap(Particle& particle, std::size_t ancestor, unsigned lane) const;
  void describe(const Particle& best, const Sight& sight);
  void record(const Particle& best, const Sight& sight, Account& account) const;
  void removeGhosts(const Particle& best, const Sight& sight, Account& account);
  Status beginAnew(const Particle& best, const Sight& sight, const Prediction* predictions,
                   PoseBelief& belief, Account& account);
  Status countBegunAnew(const LandmarkObservation& z, std::size_t number, Account& account);

  bool map_is_fixed_;
  RangeBearingModel model_;
  Associator associator_;
  std::unique_ptr<Proposal> proposal_;
  std::unique_ptr<Weighting> weighting_;
  LandmarkIndex index_;
  FitMonitor fit_;
  std::set<LandmarkId> established_;  ///< by the most likely particles, where they are now

  // of the step
  LandmarkObservationArray array_;
  bool has_seen_ = false;  ///< there may be a landmark among the observations
  Association association_;
  std::vector<Prediction> predictions_;  ///< a row of columns for each particle
  std::vector<bool> is_used_;            ///< columns that most particles did not gate
  std::vector<std::uint32_t> begun_;     ///< numbers of the landmarks begun, by observation
};

}  // namespace slam::particle_filter
