// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::particle_filter {

/// How laser scans move and weigh the particles, where these carry grid maps.
struct ScanConfig {
  static constexpr const char* kSection = "scan_matching";

  enum class Proposal { kMatched, kMotion };
  enum class Weighting { kIntegral, kLikelihood };
  enum class Matcher { kHillClimbing, kCorrelative };

  Proposal proposal = Proposal::kMatched;
  Weighting weighting = Weighting::kIntegral;
  Matcher matcher = Matcher::kHillClimbing;
  double update_distance = 0.3;
  double update_angle = 0.25;
  double update_interval = 0.0;
  double spacing = 0.05;
  double outlier = 0.01;
  double beam_information = 0.3;
  double weight_smoothing = 10.0;
  double lost_share = 0.5;
  double step_position = 0.05;
  double step_heading = 0.03;
  int step_halvings = 5;
  double window_position = 0.3;
  double window_heading = 0.2;

  void describe(Fields& fields);

 private:
  void describePolicies(Fields& fields);
  void describeUpdates(Fields& fields);
  void describeLikelihood(Fields& fields);
  void describeSearch(Fields& fields);
};

}  // namespace slam::particle_filter
