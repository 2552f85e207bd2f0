// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

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
    std::string proposal = "fastslam2", weighting = "predictive";
    double gate_probability = 0.9999;
    double lost_nis = 5.0;
    bool map_is_fixed = false;
  };

  /// Without any landmarks. @param config is valid
  explicit LandmarkUpdate(const Config& config);
  LandmarkUpdate() : LandmarkUpdate(Config()) {}

  /// These are the landmarks of the particles' maps, in this order.
  void load(const LandmarkMap& map);
  /// The robot is elsewhere: how observations fitted before says nothing any more.
  void relocate() { fit_.forget(); }

  /// The observations of a step, or none; what is left out is counted as "unknown_id", "duplicate",
  /// "not_in_map".
  /// @return whether there is a landmark among them
  bool take(const std::optional<LandmarkObservationArray>& array, Account& account);

  Drafts propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                 const PoseBelief& belief, const Execution& execution) override;
  void judge(const Weights& weights, Account& account) override;
  void inform(const PoseEstimate& moments, const Particle& best,
              KnowledgeBound& bound) const override;
  double logCorrection(const Drafts& drafts, std::size_t ancestor,
                       const Particle& drawn) const override;
  Lesson learn(ParticleSet& particles, const Ancestors& ancestors, PoseBelief& belief,
               const Execution& execution, Account& account) override;

  const LandmarkIndex& index() const { return index_; }
  bool isLost() const { return fit_.isLost(); }

 private:
  void sort(const LandmarkObservation& z, Account& account);
  bool isDoubtful() const { return hasSeen() && fit_.isDoubtful(); }
  bool hasSeen() const { return !sight_.matches.empty() || !unseen_.empty(); }
  const Prediction* predictionsOf(std::size_t particle) const {
    return predictions_.data() + particle * sight_.matches.size();
  }
  void updateMap(Particle& particle, const Prediction* predictions, unsigned lane) const;
  void beginAnew(const Particle& best, PoseBelief& belief) const;

  bool map_is_fixed_;
  RangeBearingModel model_;
  std::unique_ptr<Proposal> proposal_;
  std::unique_ptr<Weighting> weighting_;
  LandmarkIndex index_;
  FitMonitor fit_;

  // of the step
  Sight sight_;
  std::vector<LandmarkObservation> unseen_;  ///< of landmarks that are in no map yet
  std::vector<Prediction> predictions_;      ///< all of particle 0, then of particle 1, ...
  std::vector<bool> is_used_;                ///< matches that most particles did not gate
};

}  // namespace slam::particle_filter
