// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/particle_filter/landmarks/landmark_update.hpp"
#include "slam_core/particle_filter/particles/resampler.hpp"

namespace slam::particle_filter {

struct PfConfig {
  static constexpr const char* kSection = "pf";

  std::string mode = "slam";
  std::string association = "known_ids";
  std::string proposal = "fastslam2";
  std::string weighting = "predictive";
  std::string resampling = "systematic";
  double resampling_threshold = 0.75;
  int particles = 100;
  std::string size = "fixed";
  int min_particles = 30;
  int max_particles = 500;
  double kld_error = 0.05;
  double kld_quantile = 2.33;
  double kld_bin_position = 0.05;
  double kld_bin_heading = 0.05;
  double gate_probability = 0.9999;
  double lost_nis = 5.0;
  std::string pose = "auto";
  std::string map = "best";
  double initial_sigma_position = 1e-4;
  double initial_sigma_heading = 1e-4;
  double load_inflation = 2.0;
  int threads = 1;

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
