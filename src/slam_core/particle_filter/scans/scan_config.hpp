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

  Proposal proposal = Proposal::kMatched;
  Weighting weighting = Weighting::kIntegral;
  double update_distance = 0.4;
  double update_angle = 0.3;
  double update_interval = 0.0;
  double drift_position = 0.01;
  double drift_heading = 0.002;
  double outlier = 0.02;
  double unknown = 0.5;
  double beam_information = 0.3;
  double weight_smoothing = 10.0;
  double lost_share = 0.5;

  void describe(Fields& fields);

 private:
  void describePolicies(Fields& fields);
  void describeUpdates(Fields& fields);
  void describeLikelihood(Fields& fields);
  void describeDrift(Fields& fields);
};

}  // namespace slam::particle_filter
