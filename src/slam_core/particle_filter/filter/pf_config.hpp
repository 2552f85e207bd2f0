// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/association/place_config.hpp"
#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"
#include "slam_core/particle_filter/landmarks/landmark_update.hpp"
#include "slam_core/particle_filter/particles/resampler.hpp"

namespace slam::particle_filter {

/// Whether the number of particles stays, or follows the spread of the poses (Fox 2003).
enum class SetSize { kFixed, kKld };
/// The reported pose: the weighted mean, the most likely particle's, or which the map asks for.
enum class ToldPose { kAuto, kMean, kBest };
/// The reported map: the most likely particle's, or the weighted mixture.
enum class ToldMap { kBest, kMixture };

struct PfConfig {
  static constexpr const char* kSection = "pf";

  BackendMode mode = BackendMode::kSlam;
  std::string association = "known_ids";  ///< the product's, see AssociationChooser
  association::PlaceConfig places;
  std::string proposal = "fastslam2";
  std::string weighting = "predictive";
  std::string resampling = "systematic";
  double resampling_threshold = 0.75;
  int particles = 100;
  SetSize size = SetSize::kFixed;
  int min_particles = 30;
  int max_particles = 500;
  double kld_error = 0.05;
  double kld_quantile = 2.33;
  double kld_bin_position = 0.05;
  double kld_bin_heading = 0.05;
  double gate_probability = 0.9999;
  double lost_nis = 5.0;
  ToldPose pose = ToldPose::kAuto;
  ToldMap map = ToldMap::kBest;
  double initial_sigma_position = 1e-4;
  double initial_sigma_heading = 1e-4;
  double load_inflation = 2.0;
  int threads = 1;

  bool mapIsFixed() const { return mode == BackendMode::kLocalization; }
  void describe(Fields& fields);

 private:
  void describePolicies(Fields& fields);
  void describeSize(Fields& fields);
  void describeOutput(Fields& fields);
  void describeStart(Fields& fields);
};

/// @throw ConfigError listing what is out of its range, bounds that cross included
void validatePf(const PfConfig& config);

LandmarkUpdate::Config landmarksOf(const PfConfig& config);
Resampler::Config resamplingOf(const PfConfig& config);

}  // namespace slam::particle_filter
